"""Which world comes next: numbered draws, made beside the running ones."""

import concurrent.futures

from . import _core


class Worlds:
    """World number m = 0, 1, 2 ... of a draw that depends on m alone.

    draw: a function of m; what it answers is a World, or the arguments of World.generate as a dict.
    """

    def __init__(self, draw):
        self._draw = draw
        self._waiting = {}
        self._maker = None

    def make(self, number):
        world = self._draw(number)
        if isinstance(world, dict):
            world = _core.World.generate(**world)
        if not isinstance(world, _core.World):
            raise TypeError(f"world {number} is {world!r}; legal are a World and a dict of the "
                            "arguments of World.generate")
        return world

    def prepare(self, number):
        """Begins to make it on a thread of its own."""
        if number in self._waiting:
            return
        if self._maker is None:
            self._maker = concurrent.futures.ThreadPoolExecutor(
                1, thread_name_prefix="latticeworld_worlds")
        self._waiting[number] = self._maker.submit(self.make, number)

    def take(self, number):
        """Waits for it, if it is not there yet."""
        waiting = self._waiting.pop(number, None)
        return self.make(number) if waiting is None else waiting.result()

    def close(self):
        for waiting in self._waiting.values():
            waiting.cancel()
        self._waiting.clear()
        if self._maker is not None:
            self._maker.shutdown(wait=True)
            self._maker = None


def of_words(layout, environment, world_seed, **fields):
    """A draw of worlds of these words (one text or several, taken in turn) and of seeds that count
    up from world_seed."""
    layouts = [layout] if isinstance(layout, str) else list(layout)
    environments = [environment] if isinstance(environment, str) else list(environment)
    if not layouts or not environments:
        raise ValueError("layout and environment: legal are a text and a list of texts that is not "
                         "empty")

    def draw(number):
        return dict(fields, layout=layouts[number % len(layouts)],
                    environment=environments[number % len(environments)],
                    seed=world_seed + number)
    return draw


def of_list(worlds):
    """A draw that goes round these."""
    worlds = list(worlds)
    if not worlds or not all(isinstance(world, _core.World) for world in worlds):
        raise TypeError(f"worlds is {worlds!r}; legal are a function of a number and a list of "
                        "Worlds that is not empty")
    return lambda number: worlds[number % len(worlds)]
