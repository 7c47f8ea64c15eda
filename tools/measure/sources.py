"""Decides which sections are stale. A section is fresh while its sources are the same apart from comments and blanks,
or while the programs built from them contain the same code. So a renamed local makes nothing stale."""
import hashlib
import re
import subprocess
import tempfile
from functools import lru_cache
from pathlib import Path

from machine import SOURCE, Failed

LEFT_OUT = re.compile(r'\.md$|^intro/(maker/|main_debug\.cpp)')
C_LIKE = re.compile(r'\.(cpp|h|c|S|ld|js|mjs|css)$')
NAMING = re.compile(r'version\.cmake|/answers\.cpp|\.elf$|/\w+-safe$')  # build steps that write the commit's name
COMPILED = re.compile(r'\.(cpp|h|c|S|ld|js|html|model)$|CMakeLists\.txt$')
# Strings, comments, words (numbers with separators), and all other characters but blanks
TOKENS = re.compile(r'''R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`'''
                    r'''|//[^\n]*|/\*.*?\*/|[0-9][\w'.]*|\w+|[^\w\s]''', re.S)


def short(data):
    return hashlib.sha256(data).hexdigest()[:12]


def git(*words):
    done = subprocess.run(['git', '-C', str(SOURCE), *words], capture_output=True, text=True)
    if done.returncode:
        raise Failed(f'cannot find stale sections: {" ".join(done.stderr.split())}')
    return done.stdout


def commit(paths):
    """The current commit, followed by + if one of the paths has changed since."""
    return git('rev-parse', '--short=12', 'HEAD').strip() + ('+' if git('status', '--porcelain', '--', *paths) else '')


@lru_cache(None)
def files():
    names = git('ls-files', '-z', '--cached', '--others', '--exclude-standard').split('\0')
    return sorted(name for name in set(names) if name and not LEFT_OUT.search(name) and (SOURCE / name).is_file())


def inside(source):
    return [name for name in files() if name == source or name.startswith(source + '/')]


@lru_cache(None)
def read(name):
    """The content of a file without comments and blanks."""
    data = (SOURCE / name).read_bytes()
    try:
        text = data.decode()
    except UnicodeDecodeError:
        return data
    if C_LIKE.search(name):
        tokens = (found[0] for found in TOKENS.finditer(text))
        return '\n'.join(token for token in tokens if not token.startswith(('//', '/*'))).encode()
    lines = (line.rstrip() for line in text.splitlines())
    return '\n'.join(line for line in lines if line and not re.match(r'\s*#(?!!)', line)).encode()


@lru_cache(None)
def written(source):
    """A hash of the text of a file or folder."""
    return short(b'\0'.join(name.encode() + b'\0' + read(name) for name in inside(source)))


# --- Built programs ---

def contents(path, *options):
    """A program's content in memory, without symbols and debug information; the whole file if it is a page."""
    with tempfile.TemporaryDirectory() as folder:
        to = Path(folder) / 'contents'
        subprocess.run(['objcopy', '-O', 'binary', '-R', '.note*', *options, str(path), str(to)], capture_output=True)
        return (to if to.exists() else path).read_bytes()


@lru_cache(None)
def code(path):
    """A hash of a program without its commit's name."""
    return short(re.sub(rb' [0-9a-f]{12}\n', b'', contents(path)))


@lru_cache(None)
def current(build, program):
    """Whether a program is up to date: a build would write nothing but the commit's name."""
    try:
        plan = subprocess.run(['ninja', '-C', str(build), '-n', program], capture_output=True, text=True)
    except OSError:
        return False
    steps = [line for line in plan.stdout.splitlines() if line[:1] == '[']
    return not plan.returncode and all(NAMING.search(step) for step in steps)


def built(section, build):
    """The hashes of those programs of a section that are up to date."""
    return [f'{program} {code(build / program)}' for program in section.programs if current(build, program)]


# --- Sections ---

def record_of(section, build):
    """The record of a section: the commit; hashes of its sources; hashes of its programs."""
    for cached in (files, read, written, code, current):
        cached.cache_clear()  # measuring may have written files
    then = [f'{source} {written(source)}' for source in section.sources]
    return '; '.join([commit(section.sources), ', '.join(then), ', '.join(built(section, build))])


def verdict(section, record, build):
    """A line with the reason why the section is not fresh; empty if it is."""
    if not record:
        return f'unmeasured: {section.name}: run tools/measure/all --only {section.name}, {section.minutes:g} minutes'
    for source in section.sources:
        if not inside(source):
            return f'unknown: {section.name} needs {source}, which git does not have'
    measured, then, programs = (part.split(', ') for part in (record + '; ; ').split('; ')[:3])
    changed = [source for source in section.sources if f'{source} {written(source)}' not in then]
    compiled = all(COMPILED.search(source) or (SOURCE / source).is_dir() for source in changed)
    if not changed or compiled and len(programs) == len(section.programs) and built(section, build) == programs:
        return ''
    return f'stale: {section.name}: changed since {measured[0]}: {" ".join(changed)}'
