"""Training of LatticeWorld's models. Every module that has a `main` is a command of its own."""
