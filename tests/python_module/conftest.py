"""Worlds that tests share."""

import pytest

import latticeworld as lw

LAYOUT = "Flat grassland everywhere, a few trees in the upper right."
ENVIRONMENT = "A sunny summer noon. A wheeled robot waits in the center."


@pytest.fixture(scope="session")
def worlds():
    """Two of 64 m, of different words and seeds."""
    return [lw.World.generate(LAYOUT, ENVIRONMENT, seed=3, size_m=64.0),
            lw.World.generate("Gentle hills of grass, a wood in the lower left.", ENVIRONMENT, seed=4,
                              size_m=64.0)]


@pytest.fixture
def world(worlds):
    return worlds[0]
