//! Methods.

use super::call_error::CallError;
use super::world::World;
use crate::rpc::{Answer, Caller, Request};

/// A method of the protocol.
pub(super) type Method = fn(&mut World, &Call<'_>) -> Result<Answer, CallError>;

/// A request, and who made it.
pub(super) struct Call<'a> {
    pub(super) caller: &'a Caller,
    pub(super) request: &'a Request,
}
