pub(super) mod simplex;
