//! Enums from tables: a row for each variant, with its documentation and its names, so that no variant is listed twice.

/// An enum whose variants have names, from a table with a row for each: `Variant => "name";`.
macro_rules! named_variants {
    (
        $(#[doc = $about:literal])*
        pub enum $of:ident;
        $( $(#[doc = $row_about:literal])* $variant:ident => $name:literal; )+
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum $of {
            $( $(#[doc = $row_about])* $variant, )+
        }

        impl $of {
            /// All of them, in the order of their definition.
            pub const ALL: [Self; [$( $name ),+].len()] = [$( Self::$variant ),+];

            /// The name used in records: lower-case words joined by underscores.
            pub const fn name(self) -> &'static str {
                match self {
                    $( Self::$variant => $name, )+
                }
            }
        }

        impl std::fmt::Display for $of {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.name())
            }
        }
    };
}

/// The registry of a problem's methods, from a table with a row for each, the default first:
/// `Variant => id, title, cost;`.
macro_rules! methods {
    (
        $(#[doc = $about:literal])*
        pub enum Method;
        $(#[doc = $cost_about:literal])*
        fn cost;
        $(
            $(#[doc = $row_about:literal])* $(#[cfg($on:meta)])?
            $variant:ident => $id:expr, $title:expr, $cost:literal;
        )+
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Method {
            $( $(#[doc = $row_about])* $(#[cfg($on)])? $variant, )+
        }

        impl Method {
            /// Every method of this build, the default first.
            pub const ALL: [Self; [$( $(#[cfg($on)])? $id ),+].len()] = [$( $(#[cfg($on)])? Self::$variant ),+];

            /// The name of the method where questions and experiments name one; mostly that of its file.
            pub const fn id(self) -> &'static str {
                match self {
                    $( $(#[cfg($on)])? Self::$variant => $id, )+
                }
            }

            /// The method of an id.
            pub fn from_id(id: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|method| method.id() == id)
            }

            /// The method in a few words, for people.
            pub const fn title(self) -> &'static str {
                match self {
                    $( $(#[cfg($on)])? Self::$variant => $title, )+
                }
            }

            $(#[doc = $cost_about])*
            pub const fn cost(self) -> &'static str {
                match self {
                    $( $(#[cfg($on)])? Self::$variant => $cost, )+
                }
            }
        }

        impl Default for Method {
            fn default() -> Self {
                Self::ALL[0]
            }
        }
    };
}

pub(crate) use {methods, named_variants};
