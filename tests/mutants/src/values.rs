//! Values that a function may give instead of its own.

use quote::ToTokens;
use syn::{Expr, Type, parse_quote};

/// The values that stand in for every value of a type, by its name; none for a type that is not known.
pub fn values_of(result: &Type) -> Vec<Expr> {
    let name = result.to_token_stream().to_string().replace(' ', "");
    match name.as_str() {
        "bool" => vec![parse_quote!(true), parse_quote!(false)],
        "usize" | "isize" | "u8" | "u32" | "u64" | "u128" | "i8" | "i32" | "i64" | "i128" => {
            vec![parse_quote!(0), parse_quote!(1)]
        }
        "f64" => vec![parse_quote!(0.0), parse_quote!(1.0), parse_quote!(-1.0)],
        "Ordering" => vec![
            parse_quote!(std::cmp::Ordering::Less),
            parse_quote!(std::cmp::Ordering::Equal),
            parse_quote!(std::cmp::Ordering::Greater),
        ],
        _ => values_of_generic(&name),
    }
}

fn values_of_generic(name: &str) -> Vec<Expr> {
    let begins = |start| name.starts_with(start);
    if begins("Option<bool>") {
        vec![parse_quote!(None), parse_quote!(Some(true)), parse_quote!(Some(false))]
    } else if begins("Option<") {
        vec![parse_quote!(None)]
    } else if begins("Vec<") {
        vec![parse_quote!(Vec::new())]
    } else if begins("Result<(),") || name == "Result<()>" {
        vec![parse_quote!(Ok(()))]
    } else if begins("Result<bool") {
        vec![parse_quote!(Ok(true)), parse_quote!(Ok(false))]
    } else if begins("Result<Option<") {
        vec![parse_quote!(Ok(None))]
    } else {
        Vec::new()
    }
}
