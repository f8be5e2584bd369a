//! The faults: operators that are others, negations that are gone, guards that always or never hold, arms of a match
//! that are gone, functions that give a fixed value.
//!
//! An operand is written once, however many faults its operator has, so that sources grow in proportion: its value is
//! bound by a `match`, in which temporary values live as long as in the expression itself.

use std::collections::BTreeSet;

use proc_macro2::Span;
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Arm, Attribute, BinOp, Block, Expr, ExprBinary, ExprMatch, ExprRepeat, GenericArgument, ImplItemConst, ImplItemFn,
    ItemConst, ItemFn, ItemImpl, ItemMod, ItemStatic, Pat, ReturnType, Signature, Stmt, TraitItemFn, Type, UnOp,
    parse_quote,
};

use crate::values::values_of;

/// The traits whose methods only put things into words.
const WORDS: [&str; 3] = ["Debug", "Display", "Error"];

/// Gives each fault its switch.
pub struct Switches {
    next: u32,
    skipped: BTreeSet<u32>,
    lines: String,
    file: String,
    /// The functions around the place.
    functions: Vec<String>,
}

impl Switches {
    /// No faults yet; these numbers are not used.
    pub fn new(skipped: BTreeSet<u32>) -> Self {
        Self { next: 1, skipped, lines: String::new(), file: String::new(), functions: Vec::new() }
    }

    /// Names the file that follows.
    pub fn begin(&mut self, file: &str) {
        file.clone_into(&mut self.file);
    }

    /// The list of all faults.
    pub fn into_lines(self) -> String {
        self.lines
    }

    /// The condition under which a new fault is there; none for one that is skipped, or outside all functions.
    fn switch(&mut self, at: Span, change: &str) -> Option<Expr> {
        let function = self.functions.last()?;
        let number = self.next;
        self.next += 1;
        if self.skipped.contains(&number) {
            return None;
        }
        let place = at.start();
        let (file, line, column) = (&self.file, place.line, place.column + 1);
        self.lines += &format!("{number}\t{file}:{line}:{column}\t{function}\t{change}\n");
        Some(parse_quote!(crate::mutants::on(#number)))
    }

    fn function(&mut self, signature: &Signature, block: &mut Block) {
        if signature.constness.is_some() {
            return;
        }
        self.functions.push(signature.ident.to_string());
        visit_mut::visit_block_mut(self, block);
        let mut first: Vec<Stmt> = Vec::new();
        match &signature.output {
            ReturnType::Default if block.stmts.is_empty() => {}
            ReturnType::Default => {
                let on = self.switch(signature.span(), "nothing is done");
                first.extend(on.map(|on| -> Stmt { parse_quote!(if #on { return; }) }));
            }
            ReturnType::Type(_, result) => {
                for value in values_of(result) {
                    let change = format!("gives {}", value.to_token_stream());
                    let on = self.switch(signature.span(), &change);
                    first.extend(on.map(|on| -> Stmt { parse_quote!(if #on { return #value; }) }));
                }
            }
        }
        first.append(&mut block.stmts);
        block.stmts = first;
        self.functions.pop();
    }

    fn binary(&mut self, binary: &ExprBinary) -> Option<Expr> {
        let ExprBinary { left, right, op, .. } = binary;
        let at = op.span();
        if has_let(left) || has_let(right) {
            return None;
        }
        if matches!(op, BinOp::And(_)) {
            let on = self.switch(at, "&& -> ||")?;
            return Some(parse_quote!((match #left { zl => if zl != #on { #right } else { zl } })));
        }
        if matches!(op, BinOp::Or(_)) {
            let on = self.switch(at, "|| -> &&")?;
            return Some(parse_quote!((match #left { zl => if zl == #on { #right } else { zl } })));
        }
        let is_comparison = |op: &BinOp| {
            use BinOp::{Eq, Ge, Gt, Le, Lt, Ne};
            matches!(op, Eq(_) | Ne(_) | Lt(_) | Le(_) | Gt(_) | Ge(_))
        };
        let is_assignment = matches!(op, BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_));
        let with = |op: &BinOp| -> Expr {
            if is_assignment {
                parse_quote!({ #left #op zr; })
            } else if is_comparison(op) {
                parse_quote!({ *zl #op *zr })
            } else {
                parse_quote!({ zl #op zr })
            }
        };
        let mut value = with(op);
        let mut is_changed = false;
        for other in others(op) {
            let change = format!("{} -> {}", op.to_token_stream(), other.to_token_stream());
            if let Some(on) = self.switch(at, &change) {
                let changed = with(&other);
                value = parse_quote!(if #on #changed else { #value });
                is_changed = true;
            }
        }
        is_changed.then(|| {
            if is_assignment {
                parse_quote!((match #right { zr => { #value } }))
            } else if is_comparison(op) {
                parse_quote!((match (&(#left), &(#right)) { (zl, zr) => { #value } }))
            } else {
                parse_quote!((match (#left, #right) { (zl, zr) => { #value } }))
            }
        })
    }
}

/// The operators that stand in for one.
fn others(op: &BinOp) -> Vec<BinOp> {
    match op {
        BinOp::Eq(_) => vec![parse_quote!(!=)],
        BinOp::Ne(_) => vec![parse_quote!(==)],
        BinOp::Lt(_) => vec![parse_quote!(<=), parse_quote!(>)],
        BinOp::Le(_) => vec![parse_quote!(<), parse_quote!(>)],
        BinOp::Gt(_) => vec![parse_quote!(>=), parse_quote!(<)],
        BinOp::Ge(_) => vec![parse_quote!(>), parse_quote!(<)],
        BinOp::Add(_) => vec![parse_quote!(-), parse_quote!(*)],
        BinOp::Sub(_) | BinOp::Mul(_) => vec![parse_quote!(+)],
        BinOp::Div(_) => vec![parse_quote!(*)],
        BinOp::Rem(_) => vec![parse_quote!(/)],
        BinOp::BitXor(_) | BinOp::BitAnd(_) => vec![parse_quote!(|)],
        BinOp::BitOr(_) => vec![parse_quote!(&)],
        BinOp::Shl(_) => vec![parse_quote!(>>)],
        BinOp::Shr(_) => vec![parse_quote!(<<)],
        BinOp::AddAssign(_) => vec![parse_quote!(-=)],
        BinOp::SubAssign(_) | BinOp::MulAssign(_) => vec![parse_quote!(+=)],
        _ => Vec::new(),
    }
}

/// Whether an expression is a chain of conditions that binds names.
fn has_let(expression: &Expr) -> bool {
    match expression {
        Expr::Let(_) => true,
        Expr::Binary(binary) if matches!(binary.op, BinOp::And(_)) => has_let(&binary.left) || has_let(&binary.right),
        Expr::Paren(inner) => has_let(&inner.expr),
        _ => false,
    }
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    let is_test = |text: String| text.contains("cfg (test)") || text == "# [test]";
    attributes.iter().any(|attribute| is_test(attribute.to_token_stream().to_string()))
}

impl VisitMut for Switches {
    fn visit_item_mod_mut(&mut self, item: &mut ItemMod) {
        if !is_for_tests(&item.attrs) {
            visit_mut::visit_item_mod_mut(self, item);
        }
    }

    fn visit_item_fn_mut(&mut self, item: &mut ItemFn) {
        if !is_for_tests(&item.attrs) {
            self.function(&item.sig, &mut item.block);
        }
    }

    fn visit_item_impl_mut(&mut self, item: &mut ItemImpl) {
        let of_words = |path: String| WORDS.iter().any(|word| path.contains(word));
        let is_words = item.trait_.as_ref().is_some_and(|(_, path, _)| of_words(path.to_token_stream().to_string()));
        if !is_words && !is_for_tests(&item.attrs) {
            visit_mut::visit_item_impl_mut(self, item);
        }
    }

    fn visit_impl_item_fn_mut(&mut self, item: &mut ImplItemFn) {
        if !is_for_tests(&item.attrs) {
            self.function(&item.sig, &mut item.block);
        }
    }

    fn visit_trait_item_fn_mut(&mut self, item: &mut TraitItemFn) {
        if let Some(block) = &mut item.default {
            self.function(&item.sig, block);
        }
    }

    fn visit_arm_mut(&mut self, arm: &mut Arm) {
        visit_mut::visit_arm_mut(self, arm);
        let Some((_, guard)) = &mut arm.guard else { return };
        if has_let(guard) {
            return;
        }
        let at = guard.span();
        if let Some(on) = self.switch(at, "guard -> true") {
            **guard = parse_quote!(((#guard) || #on));
        }
        if let Some(on) = self.switch(at, "guard -> false") {
            **guard = parse_quote!(((#guard) && !#on));
        }
    }

    fn visit_expr_match_mut(&mut self, item: &mut ExprMatch) {
        visit_mut::visit_expr_match_mut(self, item);
        let is_rest = |arm: &Arm| matches!(arm.pat, Pat::Wild(_)) && arm.guard.is_none();
        let before_rest = item.arms.iter().position(is_rest).unwrap_or(0);
        for arm in item.arms.iter_mut().take(before_rest).filter(|arm| arm.guard.is_none()) {
            let change = format!("no arm {}", arm.pat.to_token_stream());
            if let Some(on) = self.switch(arm.pat.span(), &change) {
                arm.guard = Some((Default::default(), parse_quote!(!#on)));
            }
        }
    }

    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        visit_mut::visit_expr_mut(self, expression);
        let changed = match expression {
            Expr::Unary(unary) if matches!(unary.op, UnOp::Not(_)) => {
                let value = unary.expr.clone();
                let on = self.switch(unary.span(), "no !");
                on.map(|on| parse_quote!(((!(#value)) != #on)))
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) && !matches!(*unary.expr, Expr::Lit(_)) => {
                let value = unary.expr.clone();
                let on = self.switch(unary.span(), "no -");
                on.map(|on| parse_quote!((match #value { z => if #on { z } else { -z } })))
            }
            Expr::Binary(binary) => self.binary(binary),
            _ => None,
        };
        if let Some(changed) = changed {
            *expression = changed;
        }
    }

    // Constants, types and patterns are not evaluated when a test runs.
    fn visit_item_const_mut(&mut self, _: &mut ItemConst) {}
    fn visit_impl_item_const_mut(&mut self, _: &mut ImplItemConst) {}
    fn visit_item_static_mut(&mut self, _: &mut ItemStatic) {}
    fn visit_type_mut(&mut self, _: &mut Type) {}
    fn visit_pat_mut(&mut self, _: &mut Pat) {}
    fn visit_generic_argument_mut(&mut self, _: &mut GenericArgument) {}
    fn visit_expr_repeat_mut(&mut self, repeat: &mut ExprRepeat) {
        self.visit_expr_mut(&mut repeat.expr);
    }
}
