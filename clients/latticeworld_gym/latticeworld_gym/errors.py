"""What goes wrong between an environment and its world."""


class ServerError(RuntimeError):
    """There is no world to learn in, or it refused a call; the text says what was wrong."""
