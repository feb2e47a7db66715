//! Tests of the judge by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-judge-tests kit` runs a part.

mod accurate;
mod attitudes;
mod common;
mod compared;
mod engines_judged;
mod engines_recorded;
mod engines_table;
mod faults;
mod files;
mod growth;
mod hard;
mod in_memory;
mod invented_records;
mod kit;
mod mended;
mod names_and_units;
mod options;
mod our_own;
mod outcomes;
mod plain;
mod plain_rules;
mod times;
