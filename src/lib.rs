//! Rotation of rigid bodies.
