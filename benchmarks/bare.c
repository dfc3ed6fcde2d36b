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

static int32_t least(int32_t a, int32_t b) { return a < b ? a : b; }

static void bounce_all(Ball *balls, const int32_t *starts, const int32_t *members, int32_t cell, int32_t other,
                       double radius)
{
    for (int32_t a = starts[cell + 1]; a < starts[cell + 2]; a++) {
        Ball *one = &balls[members[a]];
        for (int32_t b = other == cell ? a + 1 : starts[other + 1]; b < starts[other + 2]; b++) {
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
}

void step_gas(int32_t count, int32_t columns, int32_t rows, double dt, double radius, double width, double height,
              Ball *balls, int32_t *cells, int32_t *starts, int32_t *members)
{
    double across = columns / width, up = rows / height;
    memset(starts, 0, sizeof(int32_t) * (columns * rows + 2));
    for (int32_t i = 0; i < count; i++) {
        reflect(&balls[i].x, &balls[i].vx, dt, radius, width - radius);
        reflect(&balls[i].y, &balls[i].vy, dt, radius, height - radius);
        cells[i] = least((int32_t)(balls[i].x * across), columns - 1)
                 + columns * least((int32_t)(balls[i].y * up), rows - 1);
        starts[cells[i] + 1]++;
    }
    for (int32_t cell = 0; cell < columns * rows; cell++) starts[cell + 1] += starts[cell];
    for (int32_t i = count - 1; i >= 0; i--) members[--starts[cells[i] + 1]] = i;
    starts[columns * rows + 1] = count;
    for (int32_t row = 0; row < rows; row++)
        for (int32_t column = 0; column < columns; column++)
            for (int32_t k = 0; k < 5; k++) {
                int32_t other_row = row + (k < 2 ? 0 : 1), other_column = column + (k < 2 ? k : k - 3);
                if (other_row < rows && other_column >= 0 && other_column < columns)
                    bounce_all(balls, starts, members, column + columns * row, other_column + columns * other_row,
                               radius);
            }
}
