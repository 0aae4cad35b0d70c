"""Faults of the system that programs run on: each is put upon a place and processes, and lifted."""

import mmap
import os
import resource
import signal
import struct
import subprocess
import threading

from ledger import promise

DAY_S = 86400
FIELDS = ("refuse_threads", "clock_shift_s", "write_delay_us", "write_error")  # as in faults.cc


class Place:
    """The folder in which programs write: a small tmpfs where we may mount one. A context."""

    def __init__(self, folder, size_mb=48):
        self.folder = folder / "disk"
        self.folder.mkdir()
        self.is_mounted = self._mount(f"size={size_mb}m,nr_inodes=2000")
        self._control = open(folder / "faults", "w+b")
        self._control.write(bytes(4 * len(FIELDS)))
        self._control.flush()
        self._memory = mmap.mmap(self._control.fileno(), 4 * len(FIELDS))
        self.environment = {"LATTICEWORLD_FAULTS": str(folder / "faults"),
                            "LATTICEWORLD_FAULTS_BELOW": str(self.folder)}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.is_mounted:
            subprocess.run(["umount", "--lazy", self.folder], check=True)
        self._memory.close()
        self._control.close()

    def _mount(self, options):
        return subprocess.run(["mount", "-t", "tmpfs", "-o", options, "latticeworld", self.folder],
                              stderr=subprocess.DEVNULL, check=False).returncode == 0

    def remount(self, options):
        subprocess.run(["mount", "-o", f"remount,{options}", self.folder], check=True)

    def set(self, **fields):
        """What the preloaded library does from now on; fields that are not named: nothing."""
        self._memory[:] = struct.pack("4i", *(fields.get(name, 0) for name in FIELDS))


class Fault:
    """One fault. needs_mount: it takes a file system of its own."""

    needs_mount = False
    may_end_nodes = False  # no program is promised to live through it
    for_commands = True  # it means something to a program that starts under it

    def __init__(self, name):
        self.name = name

    def put(self, place, programs):
        """Upon a place and programs that run."""

    def lift(self, place, programs):
        """Puts things right again."""

    def limits(self):
        """Of a program that starts: called in it before it does."""


class FullDisk(Fault):
    needs_mount = True

    def put(self, place, programs):
        with open(place.folder / "filler", "wb", buffering=0) as filler:
            try:
                while filler.write(bytes(1 << 16)):
                    pass
            except OSError:
                pass

    def lift(self, place, programs):
        (place.folder / "filler").unlink()


class NoInodes(Fault):
    needs_mount = True

    def put(self, place, programs):
        (place.folder / "fillers").mkdir()
        for number in range(10000):
            try:
                (place.folder / "fillers" / str(number)).touch()
            except OSError:
                return
        promise(False, "the file system takes any number of files")

    def lift(self, place, programs):
        for path in (place.folder / "fillers").iterdir():
            path.unlink()
        (place.folder / "fillers").rmdir()


class ReadOnly(Fault):
    needs_mount = True

    def put(self, place, programs):
        place.remount("ro")

    def lift(self, place, programs):
        place.remount("rw")


class Limit(Fault):
    """A limit of the system; of: how much a process that runs may have, by its number."""

    def __init__(self, name, kind, at_start, of):
        super().__init__(name)
        self.kind, self.at_start, self.of = kind, at_start, of
        self.may_end_nodes = kind == resource.RLIMIT_AS

    def put(self, place, programs):
        for program in programs:
            _, hard = resource.prlimit(program.pid, self.kind)
            resource.prlimit(program.pid, self.kind, (self.of(program.pid), hard))

    def lift(self, place, programs):
        for program in programs:
            if program.runs():
                _, hard = resource.prlimit(program.pid, self.kind)
                resource.prlimit(program.pid, self.kind, (hard, hard))

    def limits(self):
        _, hard = resource.getrlimit(self.kind)
        resource.setrlimit(self.kind, (self.at_start, hard))


class Preloaded(Fault):
    """A fault that faults.cc plays."""

    def __init__(self, name, **fields):
        super().__init__(name)
        self.fields = fields

    def put(self, place, programs):
        place.set(**self.fields)

    def lift(self, place, programs):
        place.set()


class Gone(Fault):
    """The folder of results is moved away; as_file: and a file has its name."""

    for_commands = False

    def __init__(self, name, as_file=False):
        super().__init__(name)
        self.as_file = as_file

    def put(self, place, programs):
        for path in self._folders(place):
            path.rename(path.with_suffix(".gone"))
            if self.as_file:
                path.write_text("a file", encoding="utf-8")

    def lift(self, place, programs):
        for gone in list(place.folder.glob("*.gone")):
            path = gone.with_suffix("")
            if path.is_file():
                path.unlink()
            if not path.exists():
                gone.rename(path)

    @staticmethod
    def _folders(place):
        return [path for path in place.folder.iterdir() if path.is_dir()]


class Stopped(Fault):
    """The processes stand still, as when a machine sleeps, and go on while they are asked."""

    for_commands = False
    REST_S = 3.0

    def put(self, place, programs):
        for program in programs:
            os.kill(program.pid, signal.SIGSTOP)
        threading.Timer(self.REST_S, self._go_on, [programs]).start()

    @staticmethod
    def _go_on(programs):
        for program in programs:
            os.kill(program.pid, signal.SIGCONT)


def _open_descriptors(pid):
    return len(os.listdir(f"/proc/{pid}/fd"))


def _memory_bytes(pid):
    with open(f"/proc/{pid}/statm", encoding="ascii") as file:
        return int(file.read().split()[0]) * resource.getpagesize()


def all_faults():
    return [
        FullDisk("disk full"), NoInodes("no inodes left"), ReadOnly("disk read-only"),
        Limit("files of 20 kB at most", resource.RLIMIT_FSIZE, 20000, lambda pid: 20000),
        Limit("no more descriptors", resource.RLIMIT_NOFILE, 12, _open_descriptors),
        Limit("8 MiB more memory", resource.RLIMIT_AS, 256 << 20,
              lambda pid: _memory_bytes(pid) + (8 << 20)),
        Preloaded("no more threads", refuse_threads=1),
        Preloaded("writing fails (EIO)", write_error=1),
        Preloaded("slow disk, 20 ms a write", write_delay_us=20000),
        Preloaded("clock set back a day", clock_shift_s=-DAY_S),
        Preloaded("clock set forward a day", clock_shift_s=DAY_S),
        Gone("folder gone"), Gone("a file in the folder's place", as_file=True),
        Stopped("stopped for 3 s")]
