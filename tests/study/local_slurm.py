# SPDX-License-Identifier: GPL-2.0-or-later
"""Debian's Slurm on this machine alone: munge, controller and one node on the loopback interface."""

import os
import shutil
import socket
import subprocess
import time

CONFIGURATION = """\
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class CannotStart(Exception):
    """Why there is no Slurm here."""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for item in sockets:
        item.bind(("127.0.0.1", 0))
    ports = [item.getsockname()[1] for item in sockets]
    for item in sockets:
        item.close()
    return ports


class LocalSlurm:
    def __init__(self, folder):
        self.folder = folder
        self.host = socket.gethostname().split(".")[0]
        self.environment = {"SLURM_CONF": str(folder / "slurm.conf")}
        os.environ.update(self.environment)
        self.daemons = []

    def start(self):
        """@throws CannotStart with the reason."""
        for program in ("munged", "slurmctld", "slurmd", "sbatch"):
            if shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin") is None:
                raise CannotStart(f"no {program} on this machine (docker/packages-tests.txt)")
        if os.getuid() != 0:
            raise CannotStart("slurmd and munged of other users need root")
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        self.folder.chmod(0o755)
        text = CONFIGURATION.format(host=self.host, folder=self.folder, ports=free_ports(2))
        (self.folder / "slurm.conf").write_text(text)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        here = self.folder
        self.daemon("munged", "--foreground", "--force", f"--socket={here}/munge.socket", f"--key-file={key}",
                    f"--pid-file={here}/munged.pid", f"--log-file={here}/munged.log",
                    f"--seed-file={here}/munge.seed")
        self.wait_for(lambda: (here / "munge.socket").exists(), "munged")
        self.daemon("slurmctld", "-D", "-f", str(here / "slurm.conf"))
        self.daemon("slurmd", "-D", "-f", str(here / "slurm.conf"), "-N", self.host)
        self.wait_for(lambda: self.ask("sinfo", "--noheader", "--format=%T") == "idle", "slurmd")

    def daemon(self, name, *words):
        path = shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")
        with open(self.folder / f"{name}.out", "w") as out:
            process = subprocess.Popen([path, *words], stdout=out, stderr=subprocess.STDOUT)
        self.daemons.append((name, process))

    def wait_for(self, holds, name, seconds=30):
        end = time.time() + seconds
        while not holds():
            ended = [item for item, process in self.daemons if process.poll() is not None]
            if ended or time.time() > end:
                name = ended[0] if ended else name
                log = self.folder / f"{name}.log"
                log = log if log.exists() else self.folder / f"{name}.out"
                last = (log.read_text().strip().splitlines() or ["no word"])[-1]
                raise CannotStart(f"{name} does not start here: {last}")
            time.sleep(0.2)

    def ask(self, *command):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return done.stdout.strip()

    def node(self, state):
        subprocess.run(
            ["scontrol", "update", f"nodename={self.host}", f"state={state}", "reason=test"], check=True
        )

    def jobs(self):
        """{number: state}"""
        lines = self.ask("squeue", "--states=all", "--noheader", "--format=%i %T").splitlines()
        return {int(line.split()[0]): line.split()[1] for line in lines}

    def stop(self):
        subprocess.run(["scancel", "--user=root"], stderr=subprocess.DEVNULL)
        for _, process in reversed(self.daemons):
            process.terminate()
            process.wait()
