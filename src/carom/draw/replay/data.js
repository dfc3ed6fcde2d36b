// What the page was given. Most of it are columns of integers, packed so that the file stays small.

/** What some text holds deflated. */
function inflated(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
}

/** The integers of a packed column: varints of differences along each row (see `packing.py`). */
async function unpacked(column) {
  const bytes = new Uint8Array(await inflated(column.data).arrayBuffer());
  const values = new Float64Array(column.rows * column.length);
  let place = 0;
  for (let row = 0; row < column.rows; row++) {
    const sums = new Float64Array(column.order);
    for (let index = 0; index < column.length; index++) {
      let number = 0;
      let weight = 1;
      // No shifts: the numbers may need more than 32 bits.
      for (; bytes[place] > 127; place++, weight *= 128) number += (bytes[place] - 128) * weight;
      number += bytes[place++] * weight;
      let value = number % 2 ? -(number + 1) / 2 : number / 2;
      for (let level = 0; level < column.order; level++) value = sums[level] += value;
      values[row * column.length + index] = value;
    }
  }
  return values;
}

/** A column of numbers that were rounded to whole multiples of `unit`, counted from `first`. */
async function measured(column) {
  const values = await unpacked(column);
  for (let index = 0; index < values.length; index++) values[index] = column.first + column.unit * values[index];
  return values;
}

/** A column of sizes between 0 and `largest`, of which the logarithms were rounded. Level 0 is nothing at all. */
async function sizes(column) {
  const levels = await unpacked(column);
  return levels.map((level) => (level ? column.largest * Math.exp((level - column.top) / column.fineness) : 0));
}

/** Everything in the page's data, its columns unpacked. */
async function readRun(given) {
  const { balls, moving, hits } = given;
  const [times, energy, switches, x, y, states, turns, pivotX, pivotY] = await Promise.all([
    measured(given.times), measured(given.energy), unpacked(given.switches), measured(balls.x), measured(balls.y),
    unpacked(balls.states), measured(moving.turns), measured(moving.x), measured(moving.y),
  ]);
  const [time, kind, ball, thing, hitX, hitY, normal, speed, impulse] = await Promise.all([
    measured(hits.time), unpacked(hits.kind), unpacked(hits.ball), unpacked(hits.thing), measured(hits.x),
    measured(hits.y), measured(hits.normal), sizes(hits.speed), sizes(hits.impulse),
  ]);
  return {
    ...given,
    pieces: await inflated(given.pieces).json(),
    times,
    energy,
    switches,
    balls: { count: given.radii.length, radii: given.radii, x, y, states },
    moving: { turns, x: pivotX, y: pivotY },
    hits: { total: hits.total, count: time.length, time, kind, ball, thing, x: hitX, y: hitY, normal, speed, impulse },
  };
}
