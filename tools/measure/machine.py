"""Runs programs and measures their time and memory; builds them; starts a display for them."""
import argparse
import ctypes
import os
import shlex
import subprocess
import sys
import tempfile
import textwrap
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
for variable in subprocess.getoutput('git rev-parse --local-env-vars').split():
    if 'CONFIG_' not in variable:
        os.environ.pop(variable, None)  # as tools/build/environment.sh does
PROCESSORS = len(os.sched_getaffinity(0))


class Failed(Exception):
    """An error, as a line for the user."""


def say(what):
    print(f'  {what}', file=sys.stderr, flush=True)


@dataclass
class Took:
    printed: str
    clock: float  # seconds by the clock
    processor: float  # seconds of all threads, user and system
    megabytes: float  # largest resident set


def command_line(name, about, **more):
    """The command line of a script in tools/measure. It refuses wrong options in one line."""
    script = f'tools/measure/{name}'
    line = argparse.ArgumentParser(prog=script, allow_abbrev=False, description=about, **more)
    line.error = lambda why: (print(f'{script}: {why}: see {script} --help', file=sys.stderr), sys.exit(2))
    return line


class Machine:
    """The environment of a section: built programs, a working folder, the page, commands, and values shown in texts."""

    def __init__(self, build, work, built=True, page=None):
        self.build, self.work, self.built, self.page = Path(build), Path(work), built, page
        self.kept = {}  # results that several parts share
        self.begin()

    def begin(self):
        self.commands, self.facts = [], {}

    def once(self, make):
        """The result of make(machine), which is called once in a run."""
        if make not in self.kept:
            self.kept[make] = make(self)
        return self.kept[make]

    def words(self, command):
        """The words of a command. Paths that begin with a folder of the repository become absolute."""
        folders = {'build': self.build, **{name: SOURCE / name for name in ('intro', 'tests', 'tools')}}
        words = shlex.split(command) if isinstance(command, str) else [str(word) for word in command]
        found = [(folders.get(word.partition('/')[0]), word.partition('/')[2]) for word in words]
        return [str(folder / rest) if folder and rest else word for word, (folder, rest) in zip(words, found)]

    def note(self, command):
        """Adds a command to the section's head."""
        text = command if isinstance(command, str) else shlex.join(map(str, command))
        text = textwrap.shorten(text, 150, placeholder=' ...')
        self.commands = [one for one in self.commands if one != text] + [text]

    def timed(self, command, noted=True):
        if noted:
            self.note(command)
        words, began = self.words(command), time.monotonic()
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            try:
                process = subprocess.Popen(words, cwd=self.work, stdout=out, stderr=err)
            except OSError as why:
                raise Failed(f'{words[0]}: {why.strerror}') from None
            try:
                _, status, usage = os.wait4(process.pid, 0)
            except BaseException:
                process.kill()  # this program is being stopped
                raise
            process.returncode = os.waitstatus_to_exitcode(status)
            clock = time.monotonic() - began
            out.seek(0), err.seek(0)
            printed, wrong = out.read().decode(errors='replace'), err.read().decode(errors='replace')
        if process.returncode:
            last = (wrong.strip() or printed.strip() or f'status {process.returncode}').splitlines()[-1]
            name = Path(words[0]).name + ': '
            raise Failed(name + last.removeprefix(name))
        if noted:
            say(f'{clock:6.1f} s  {self.commands[-1]}')
        return Took(printed, clock, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)

    def run(self, command, noted=True):
        """The output of a command."""
        return self.timed(command, noted).printed

    @contextmanager
    def display(self, size='1280x720'):
        """Provides a display in memory."""
        ours, theirs = os.pipe()
        server = subprocess.Popen(
            ['Xvfb', '-noreset', '-displayfd', str(theirs), '-screen', '0', f'{size}x24', '-nolisten', 'tcp'],
            pass_fds=[theirs], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(theirs)
        with os.fdopen(ours) as number:
            os.environ['DISPLAY'] = ':' + number.readline().strip()
        try:
            if os.environ['DISPLAY'] == ':':
                raise Failed('Xvfb did not start: install xvfb')
            yield
        finally:
            server.terminate()
            server.wait()


def at_once(function, items):
    """The results of function(item) for each item, computed on all processors."""
    with ThreadPoolExecutor(PROCESSORS) as pool:
        return list(pool.map(function, items))


def build(packages, targets, folder, *options):
    """Installs missing packages and builds the targets, as the scripts do."""
    script = f'''. tools/build/packages.sh; need_for_building; [ -z "$1" ] || need "measuring" $1
        BUILD=$2 build $3 "${{@:4}}"'''
    done = subprocess.run(
        ['bash', '-euc', script, 'tools/measure', ' '.join(packages), str(folder), ' '.join(targets), *options],
        cwd=SOURCE, env={**os.environ, 'ODRAZ': str(SOURCE)}, stdout=sys.stderr)
    if done.returncode:
        raise Failed(f'the build failed: see {folder}/build.log')


class Load:
    """Measures how many processors other programs keep busy."""

    def __init__(self):
        ctypes.CDLL(None).prctl(36, 1)  # PR_SET_CHILD_SUBREAPER: orphans become children of this process
        self.clock, self.all, self.own = time.monotonic(), self.busy(), self.ours()

    @staticmethod
    def busy():
        ticks = [int(word) for word in open('/proc/stat').readline().split()[1:]]
        return (sum(ticks[:3]) + sum(ticks[5:8])) / os.sysconf('SC_CLK_TCK')

    @staticmethod
    def ours():
        with suppress(ChildProcessError):  # reap and count the processes that browsers leave behind
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        return sum(os.times()[:4])

    def seconds(self):
        return time.monotonic() - self.clock

    def others(self):
        return max(0, self.busy() - self.all - self.ours() + self.own) / (self.seconds() + 0.01)
