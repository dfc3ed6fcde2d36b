/* The loop of bare.py, statement for statement: see there. */
#include <math.h>
#include <stdint.h>
#include <string.h>

typedef struct { double x, y, vx, vy; } Ball;

static void reflect(double *place, double *speed, double dt, double radius, double end)
{
    *place += dt * *speed;
    if (*place < radius) { *place = radius; *speed = fabs(*speed); }
    else if (*place > end) { *place = end; *speed = -fabs(*speed); }
}

static uint32_t least(uint32_t a, uint32_t b) { return a < b ? a : b; }

static void bounce_all(Ball *balls, const uint32_t *members, uint32_t i, uint32_t begin, uint32_t end, double radius)
{
    Ball *one = &balls[i];
    for (uint32_t b = begin; b < end; b++) {
        Ball *two = &balls[members[b]];
        double x = two->x - one->x, y = two->y - one->y, squared = x * x + y * y;
        if (squared < 4.0 * radius * radius && squared > 0.0) {
            double distance = sqrt(squared);
            x /= distance;
            y /= distance;
            double push = 0.5 * (2.0 * radius - distance);
            one->x -= push * x;
            one->y -= push * y;
            two->x += push * x;
            two->y += push * y;
            double closing = (two->vx - one->vx) * x + (two->vy - one->vy) * y;
            if (closing < 0.0) {
                one->vx += closing * x;
                one->vy += closing * y;
                two->vx -= closing * x;
                two->vy -= closing * y;
            }
        }
    }
}

void step_gas(uint32_t count, uint32_t columns, uint32_t rows, double dt, double radius, double width, double height,
              Ball *balls, uint32_t *cells, uint32_t *starts, uint32_t *members)
{
    double across = columns / width, up = rows / height;
    memset(starts, 0, sizeof(uint32_t) * (columns * rows + 2));
    for (uint32_t i = 0; i < count; i++) {
        reflect(&balls[i].x, &balls[i].vx, dt, radius, width - radius);
        reflect(&balls[i].y, &balls[i].vy, dt, radius, height - radius);
        cells[i] = least((uint32_t)(balls[i].x * across), columns - 1)
                 + columns * least((uint32_t)(balls[i].y * up), rows - 1);
        starts[cells[i] + 1]++;
    }
    for (uint32_t cell = 0; cell < columns * rows; cell++) starts[cell + 1] += starts[cell];
    for (uint32_t i = count; i-- > 0;) members[--starts[cells[i] + 1]] = i;
    starts[columns * rows + 1] = count;
    for (uint32_t a = 0; a < count; a++) {
        uint32_t i = members[a], cell = cells[i], above = cell + columns;
        uint32_t left = cell % columns > 0, right = (cell + 1) % columns > 0;
        bounce_all(balls, members, i, a + 1, starts[cell + 2 + right], radius);
        if (above < columns * rows)
            bounce_all(balls, members, i, starts[above + 1 - left], starts[above + 2 + right], radius);
    }
}
