"""Faults of the system that programs run on: each is put upon a place and processes, and lifted."""

import errno
import mmap
import os
import pathlib
import resource
import signal
import struct
import subprocess
import threading

from ledger import promise

DAY_S = 86400
FIELDS = ("refuse_threads", "refuse_processes", "clock_shift_s", "write_delay_us", "write_error",
          "read_error", "names_hang")  # as in faults.cc
GROUPS = pathlib.Path("/sys/fs/cgroup")


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
        self._memory[:] = struct.pack(f"{len(FIELDS)}i", *(fields.get(name, 0) for name in FIELDS))


class Fault:
    """One fault."""

    may_end_nodes = False  # no program is promised to live through it

    def __init__(self, name):
        self.name = name

    def missing(self, place):
        """What this system lacks for it; empty: nothing."""
        return "" if place.is_mounted else "nothing may be mounted here"

    def put(self, place, programs):
        """Upon a place and programs that run."""

    def upon(self, program):
        """Upon a command that has just started under it."""

    def lift(self, place, programs):
        """Puts things right again."""

    def limits(self):
        """Of a program that starts: called in it before it does."""


class FullDisk(Fault):
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
    def put(self, place, programs):
        place.remount("ro")

    def lift(self, place, programs):
        place.remount("rw")


class Limit(Fault):
    """A limit of the system; of: how much a process that runs may have, by its number."""

    def missing(self, place):
        return ""

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

    def missing(self, place):
        return ""

    def put(self, place, programs):
        place.set(**self.fields)

    def lift(self, place, programs):
        place.set()


class Gone(Fault):
    """The folders of results are moved away; as_file: and a file has their names."""

    def __init__(self, name, as_file=False):
        super().__init__(name)
        self.as_file = as_file

    def missing(self, place):
        return ""

    def put(self, place, programs):
        for path in [path for path in place.folder.iterdir() if path.is_dir()]:
            path.rename(path.with_suffix(".gone"))
            if self.as_file:
                path.write_text("a file", encoding="utf-8")

    def lift(self, place, programs):
        for gone in list(place.folder.glob("*.gone")):
            path = gone.with_suffix("")
            if path.is_file():
                path.unlink()
            if not path.exists():  # else it was made anew
                gone.rename(path)


class Stopped(Fault):
    """The processes stand still, as when a machine sleeps, and go on while they are asked."""

    REST_S = 3.0

    def missing(self, place):
        return ""

    def put(self, place, programs):
        for program in programs:
            self.upon(program)

    def upon(self, program):
        os.kill(program.pid, signal.SIGSTOP)
        threading.Timer(self.REST_S, os.kill, [program.pid, signal.SIGCONT]).start()


class MemoryGroup(Fault):
    """A control group (cgroup) whose processes may have only so much more memory together; the
    system ends one that takes more."""

    may_end_nodes = True
    MORE_BYTES = 8 << 20
    AT_START_BYTES = 24 << 20

    def __init__(self, name):
        super().__init__(name)
        first = (GROUPS / "memory" / "memory.limit_in_bytes").exists()  # version 1
        self.above = GROUPS / "memory" if first else GROUPS
        self.limit = "memory.limit_in_bytes" if first else "memory.max"
        self.group = self.above / f"latticeworld_{os.getpid()}"

    def missing(self, place):
        try:
            self.group.mkdir(exist_ok=True)
            return "" if (self.group / self.limit).exists() else "control groups have no memory"
        except OSError as error:
            return f"no control group may be made: {error.strerror}"

    def put(self, place, programs):
        (self.group / self.limit).write_text(str(self.MORE_BYTES if programs else
                                                 self.AT_START_BYTES), encoding="ascii")
        for program in programs:  # what they have counts as the group's that it was charged to
            (self.group / "cgroup.procs").write_text(str(program.pid), encoding="ascii")

    def limits(self):
        (self.group / "cgroup.procs").write_text(str(os.getpid()), encoding="ascii")

    def lift(self, place, programs):
        for pid in (self.group / "cgroup.procs").read_text(encoding="ascii").split():
            (self.above / "cgroup.procs").write_text(pid, encoding="ascii")
        self.group.rmdir()


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
        Limit("8 MiB more memory", resource.RLIMIT_AS, 280 << 20,
              lambda pid: _memory_bytes(pid) + (8 << 20)),
        Preloaded("no more threads", refuse_threads=1),
        MemoryGroup("control group with 8 MiB more memory"),
        Preloaded("no more processes", refuse_processes=1),
        Preloaded("quota used up (EDQUOT)", write_error=errno.EDQUOT),
        Preloaded("writing fails (EIO)", write_error=errno.EIO),
        Preloaded("reading fails (EIO)", read_error=errno.EIO),
        Preloaded("slow disk, 20 ms a write", write_delay_us=20000),
        Preloaded("clock set back a day", clock_shift_s=-DAY_S),
        Preloaded("clock set forward a day", clock_shift_s=DAY_S),
        Preloaded("looking up names hangs", names_hang=1), Gone("folder gone"),
        Gone("a file in the folder's place", as_file=True),
        Stopped("stopped for 3 s")]
