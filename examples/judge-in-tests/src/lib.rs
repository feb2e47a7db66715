//! An engine's step of a body that nothing touches, in single precision, as short as it can be.

/// An attitude (w, x, y, z; body to world) and a spin (body axes, rad/s) after a step of `h` seconds, for a
/// body with these principal moments: the momentum turns about one axis of the body after the other.
pub fn step(attitude: [f32; 4], spin: [f32; 3], moments: [f32; 3], h: f32) -> ([f32; 4], [f32; 3]) {
    let (mut q, mut momentum) = (attitude, spin);
    (0..3).for_each(|i| momentum[i] *= moments[i]);
    for (axis, part) in [(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)] {
        let angle = momentum[axis] / moments[axis] * part * h;
        let (sine, cosine) = angle.sin_cos();
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let (y, z) = (momentum[j], momentum[k]);
        (momentum[j], momentum[k]) = (cosine * y + sine * z, cosine * z - sine * y);
        q = turned(q, axis, angle);
    }
    (0..3).for_each(|i| momentum[i] /= moments[i]);
    let length = q.iter().map(|x| x * x).sum::<f32>().sqrt();
    (q.map(|x| x / length), momentum)
}

/// An attitude turned by an angle about an axis of the body.
fn turned(q: [f32; 4], axis: usize, angle: f32) -> [f32; 4] {
    let (sine, cosine) = (angle / 2.0).sin_cos();
    let (i, j, k) = (1 + axis, 1 + (axis + 1) % 3, 1 + (axis + 2) % 3);
    let mut to = q;
    to[0] = cosine * q[0] - sine * q[i];
    to[i] = cosine * q[i] + sine * q[0];
    to[j] = cosine * q[j] + sine * q[k];
    to[k] = cosine * q[k] - sine * q[j];
    to
}
