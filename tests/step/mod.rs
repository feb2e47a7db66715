mod engine_rules;
mod geometric;
mod methods;
mod pitfalls;
mod rk4;
mod stepper;
mod torque;
