"""What the core says where it cannot do as it is told; the text has what was given and what is legal."""


class LatticeWorldError(RuntimeError):
    """code: gRPC's name of the kind of failure, as "FAILED_PRECONDITION"."""

    code = "UNKNOWN"


class InvalidArgument(LatticeWorldError, ValueError):
    pass


class NotFound(LatticeWorldError, LookupError):
    pass


class OutOfMemory(LatticeWorldError, MemoryError):
    pass


class Cancelled(LatticeWorldError):
    pass


_KINDS = {"INVALID_ARGUMENT": InvalidArgument, "OUT_OF_RANGE": InvalidArgument,
          "ALREADY_EXISTS": InvalidArgument, "NOT_FOUND": NotFound,
          "RESOURCE_EXHAUSTED": OutOfMemory, "CANCELLED": Cancelled}


def of_status(code, message):
    """The exception of a failure of the core."""
    error = _KINDS.get(code, LatticeWorldError)(message)
    error.code = code
    return error
