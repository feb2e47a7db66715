// Vectors, turns and written numbers.

export const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
export const cross = (a, b) => [0, 1, 2].map((k) => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
export const size = (a) => Math.hypot(...a);
export const unit = (a) => a.map((x) => x / size(a));
export const near = (a, b, most) => Math.abs(a - b) <= most;

/** A vector turned by a unit quaternion (w, x, y, z): q v q*. */
export function turned([w, ...u], v) {
  const once = cross(u, v).map((x, k) => x + w * v[k]); // of q v, the vector; its real part is -u.v
  return cross(u, once).map((x, k) => dot(u, v) * u[k] + w * once[k] + x);
}

/** The linear map from places in space to those in the drawing that fits best: two rows; and the greatest distance left. */
export function fitted(pairs) {
  const sums = [0, 1, 2].map((i) => [0, 1, 2].map((j) => pairs.reduce((sum, [p]) => sum + p[i] * p[j], 0)));
  const [a, b, c] = sums;
  const inverse = [cross(b, c), cross(c, a), cross(a, b)].map((row) => row.map((x) => x / dot(a, cross(b, c)))); // symmetric
  const rows = [0, 1].map((k) => {
    const right = [0, 1, 2].map((i) => pairs.reduce((sum, [p, q]) => sum + p[i] * q[k], 0));
    return inverse.map((row) => dot(row, right));
  });
  const left = Math.max(...pairs.map(([p, q]) => Math.hypot(dot(rows[0], p) - q[0], dot(rows[1], p) - q[1])));
  return { rows, left };
}

/** A written number, also with a raised power of ten. */
export function read(text) {
  const [, digits, power] = text.replace(/−/g, "-").match(/(-?[\d.]+)(?: · 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/) ?? [];
  return Number(`${digits}e${power ? Array.from(power, (sign) => "-0123456789"["⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(sign)]).join("") : 0}`);
}
