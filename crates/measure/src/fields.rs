//! Values as the fields of a record have them, written and read back.

use std::str::FromStr;

/// What went wrong with a record, in words.
pub type Wrong = String;

/// A value of a record: a row, or a field of one.
pub trait Fields: Sized {
    /// The columns of a value that is called `name`: that one, or those of its own fields.
    #[must_use]
    fn columns(name: &'static str) -> Vec<&'static str> {
        vec![name]
    }

    /// Appends its fields, as many as there are columns, without commas.
    fn write(&self, fields: &mut Vec<String>);

    /// Back from its fields, which it takes off the front.
    ///
    /// # Errors
    /// What cannot be read.
    fn read<'a>(fields: &mut impl Iterator<Item = &'a str>) -> Result<Self, Wrong>;
}

/// A structure whose fields are the columns, in order.
macro_rules! row {
    ($(#[$about:meta])* pub struct $Row:ident { $($(#[$says:meta])* pub $field:ident: $T:ty,)* }) => {
        $(#[$about])*
        pub struct $Row { $($(#[$says])* pub $field: $T,)* }

        impl $crate::fields::Fields for $Row {
            fn columns(_: &'static str) -> Vec<&'static str> {
                [$(<$T as $crate::fields::Fields>::columns(stringify!($field))),*].concat()
            }

            fn write(&self, fields: &mut Vec<String>) {
                $($crate::fields::Fields::write(&self.$field, fields);)*
            }

            fn read<'a>(fields: &mut impl Iterator<Item = &'a str>) -> Result<Self, $crate::fields::Wrong> {
                Ok(Self { $($field: $crate::fields::Fields::read(fields)?),* })
            }
        }
    };
}
pub(crate) use row;

/// In one field, where a comma would begin the next: a semicolon stands for it.
pub(crate) fn plain(text: &str) -> String {
    text.replace(',', ";").replace(['\n', '\r'], " ")
}

/// With its commas again.
pub(crate) fn full(field: &str) -> String {
    field.replace(';', ",")
}

pub(crate) fn next<'a>(fields: &mut impl Iterator<Item = &'a str>) -> Result<&'a str, Wrong> {
    fields.next().ok_or_else(|| "too few fields".into())
}

pub(crate) fn parsed<T: FromStr>(field: &str) -> Result<T, Wrong> {
    field.parse().map_err(|_| format!("`{field}` cannot be read"))
}

/// A value of one field.
macro_rules! field {
    ($T:ty, $write:expr, $read:expr) => {
        impl $crate::fields::Fields for $T {
            fn write(&self, fields: &mut Vec<String>) {
                fields.push($write(self));
            }

            fn read<'a>(fields: &mut impl Iterator<Item = &'a str>) -> Result<Self, $crate::fields::Wrong> {
                $read($crate::fields::next(fields)?)
            }
        }
    };
}
pub(crate) use field;

field!(String, |text: &str| plain(text), |field| Ok(full(field)));
field!(u32, u32::to_string, parsed);
field!(u64, u64::to_string, parsed);
field!(f64, |x| format!("{x:.3e}"), parsed);

impl<T: Fields> Fields for Option<T> {
    fn write(&self, fields: &mut Vec<String>) {
        match self {
            Some(value) => value.write(fields),
            None => fields.push(String::new()),
        }
    }

    fn read<'a>(fields: &mut impl Iterator<Item = &'a str>) -> Result<Self, Wrong> {
        match next(fields)? {
            "" => Ok(None),
            field => T::read(&mut std::iter::once(field)).map(Some),
        }
    }
}
