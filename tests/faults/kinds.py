# SPDX-License-Identifier: GPL-2.0-or-later
"""The faults, each a function of a scene, the source of chance and how often; it yields a word for
each that went well and raises Failure for one that did not."""

import os
import resource
import shutil
import signal
import subprocess
import time

from scene import Failure, expect_one_line, tail, whole_restart


def kill(process):
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


def kills_at_random_moments(scene, chance, count, ranks=1):
    """Killed up to four times on its way, at moments as likely late as early."""
    duration = scene.reference(ranks)[1]
    while count > 0:
        run = scene.fresh() / "run"
        for _ in range(min(count, 4)):
            process = scene.start(run, ranks)
            time.sleep(chance.uniform(0, duration))
            kill(process)
            count -= 1
            yield "kill"
        scene.complete(run, "killed at random moments", ranks)
        scene.expect_the_same(run, "killed at random moments", ranks)
        shutil.rmtree(run.parent)


def _at_writes(scene, chance, count, kind):
    tracer = scene.programs / "fault_at"
    folder = scene.fresh()
    counted = folder / "count"

    def traced(run, at):
        process = scene.start(run, LIGGGHTS=tracer, FAULT_PROGRAM=scene.liggghts, FAULT_UNDER=run,
                              FAULT_AT=at, FAULT_KIND=kind, FAULT_COUNT=counted)
        return scene.finish(process, f"{kind} at write {at}")

    status = traced(folder / "run", 0)
    if status == 77 or not counted.exists():
        return  # no tracing here
    if status != 0:
        raise Failure(f"traced run: status {status}: {tail(folder / 'run')}")
    writes = int(counted.read_text())
    if writes < 50:
        raise Failure(f"only {writes} writes were seen")
    moments = range(1, writes + 1) if count is None else sorted(chance.sample(range(1, writes + 1), count))
    for at in moments:
        what = f"{'killed' if kind == 'kill' else 'full disk'} at write {at} of {writes}"
        run = scene.fresh() / "run"
        if traced(run, at) == 0:
            raise Failure(f"{what}: exit status 0")
        if kind == "full" and "ERROR" not in tail(run):
            raise Failure(f"{what}: the reason is not said: {tail(run)}")
        if (run / "result.json").exists() and at < writes - 3:
            raise Failure(f"{what}: there is a result already")
        scene.complete(run, what)
        scene.expect_the_same(run, what)
        shutil.rmtree(run.parent)
        yield what


def kills_at_writes(scene, chance, count):
    yield from _at_writes(scene, chance, count, "kill")


def full_at_writes(scene, chance, count):
    yield from _at_writes(scene, chance, count, "full")


def small_limits_of_file_size(scene, chance, count):
    """Files must not grow beyond some size, then they may."""
    sizes = sorted({len(text) for text in scene.reference()[0].values()})
    largest = max(file.stat().st_size for file in (scene.reference()[2] / "restart").iterdir())
    for _ in range(count):
        size = chance.randrange(200, max(sizes[-1], largest))
        what = f"files of {size} bytes at most"
        run = scene.fresh() / "run"
        status = scene.finish(
            scene.start(run, limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))), what)
        if status == 0:
            raise Failure(f"{what}: exit status 0")
        if run.exists():
            scene.complete(run, what)
            scene.expect_the_same(run, what)
        yield what


class Mounted:
    """A file system of its own size in a folder; None where that is not allowed."""

    def __init__(self, folder, size):
        self.folder, self.size = folder, size

    def __enter__(self):
        self.folder.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={self.size}", "tmpfs", self.folder],
                              stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        return self if done.returncode == 0 else None

    def remount(self, options):
        subprocess.run(["mount", "-o", f"remount,{options}", self.folder], check=True)

    def __exit__(self, *_):
        subprocess.run(["umount", self.folder], stderr=subprocess.DEVNULL)


def small_disks(scene, chance, count):
    """Disks of every size that is too small; then there is room."""
    whole = sum(file.stat().st_size for file in scene.reference()[2].rglob("*") if file.is_file())
    for _ in range(count):
        size = 4096 * chance.randrange(4, max(5, whole // 4096))
        what = f"disk of {size} bytes"
        with Mounted(scene.fresh() / "disk", size) as disk:
            if not disk:
                return
            run = disk.folder / "run"
            if scene.finish(scene.start(run), what) == 0:
                yield f"{what}: it was enough"
                continue
            disk.remount(f"size={4 * whole + (1 << 20)}")
            scene.complete(run, what)
            scene.expect_the_same(run, what)
        yield what


def folders_that_become_read_only(scene, chance, count):
    for _ in range(count):
        what = "read-only on the way"
        with Mounted(scene.fresh() / "disk", 1 << 26) as disk:
            if not disk:
                return
            run = disk.folder / "run"
            subprocess.run(["cp", "-r", scene.reference()[2], run], check=True)
            (run / "result.json").unlink()
            # Nothing is open for writing yet.
            disk.remount("ro")
            status, output = scene.liggghts_alone(run, "-var", "resume", whole_restart.last_whole(run))
            if status == 0:
                raise Failure(f"{what}: exit status 0")
            expect_one_line(output, what)
            disk.remount("rw")
            scene.complete(run, what)
            scene.expect_the_same(run, what)
        yield what


def folders_that_vanish(scene, chance, count):
    duration = scene.reference()[1]
    for _ in range(count):
        what = "the folder is moved away on the way"
        run = scene.fresh() / "run"
        away = run.parent / "away"
        process = scene.start(run)
        scene.wait_until_under_way(run)
        time.sleep(chance.uniform(0, 0.3) * duration)
        run.rename(away)
        status = scene.finish(process, what)
        if status == 0 and not (away / "result.json").exists():
            raise Failure(f"{what}: exit status 0 without a result")
        shutil.rmtree(run, ignore_errors=True)
        away.rename(run)
        scene.complete(run, what)
        scene.expect_the_same(run, what)
        yield what


def lost_ranks(scene, chance, count):
    """One of two ranks dies: the other must not wait for it."""
    duration = scene.reference(2)[1]
    for _ in range(count):
        what = "one rank of two is killed"
        run = scene.fresh() / "run"
        process = scene.start(run, 2)
        scene.wait_until_under_way(run)
        time.sleep(chance.uniform(0, 0.5) * duration)
        found = subprocess.run(["pgrep", "-f", f"liggghts.*-var out {run} "], stdout=subprocess.PIPE)
        ranks = [int(pid) for pid in found.stdout.split() if _is_rank(pid, scene)]
        if ranks:
            try:
                os.kill(chance.choice(ranks), signal.SIGKILL)
            except ProcessLookupError:
                pass
        scene.finish(process, what)
        scene.complete(run, what, 2)
        scene.expect_the_same(run, what, 2)
        yield what


def _is_rank(pid, scene):
    try:
        return os.readlink(f"/proc/{int(pid)}/exe") == str(scene.liggghts)
    except OSError:
        return False


def other_ranks(scene, chance, count):
    """What some number of ranks began another number goes on with."""
    pairs = [(a, b) for a in (1, 2, 4) for b in (1, 2, 4)]
    for began, goes_on in chance.sample(pairs, min(count, len(pairs))):
        what = f"a file of {began} ranks read by {goes_on}"
        run = scene.fresh() / "run"
        scene.reference(began)
        subprocess.run(["cp", "-r", scene.reference(began)[2], run], check=True)
        _forget_the_end(run, chance)
        scene.complete(run, what, goes_on)
        if began == goes_on:
            scene.expect_the_same(run, what, began)
        yield what


def _forget_the_end(run, chance):
    """As if the run had been killed behind some restart file."""
    (run / "result.json").unlink()
    files = sorted((run / "restart").glob("*.[0-9]*.restart"), key=lambda f: int(f.name.split(".")[1]))
    for file in files[chance.randrange(1, len(files)):]:
        file.unlink()


def damaged_restarts(scene, chance, count):
    """The last restart file is flipped or cut: it is refused, and the one before it is taken."""
    for k in range(count):
        run = scene.fresh() / "run"
        subprocess.run(["cp", "-r", scene.reference()[2], run], check=True)
        _forget_the_end(run, chance)
        last = whole_restart.last_whole(run)
        content = bytearray(open(last, "rb").read())
        if k % 3 == 0:
            size = chance.choice([0, 16, 100, chance.randrange(len(content))])
            what, content = f"restart file cut to {size} bytes", content[:size]
        elif k % 3 == 1:
            at = chance.randrange(len(content))
            what = f"restart file with a bit flipped in byte {at}"
            content[at] ^= 1 << chance.randrange(8)
        else:
            at = chance.randrange(len(content))
            what = f"restart file of zeros from byte {at} on"
            content[at:] = bytes(len(content) - at)
            if content == open(last, "rb").read():
                continue
        with open(last, "wb") as file:
            file.write(content)
        gigabyte = 1 << 30
        status, output = scene.liggghts_alone(
            run, "-var", "resume", last,
            limit=lambda: resource.setrlimit(resource.RLIMIT_AS, (4 * gigabyte, 4 * gigabyte)))
        if status == 0:
            raise Failure(f"{what}: accepted")
        expect_one_line(output, what)
        scene.complete(run, what)
        scene.expect_the_same(run, what)
        yield what
