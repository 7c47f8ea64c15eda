"""Code includes and links only rooms that its own room knows (tools/build/rooms.cmake), and no room knows itself. The
film is built from intro/ and packer/. The end-to-end tests are short files of Python. Links of pages exist."""
import os
import re
from collections import defaultdict
from pathlib import PurePosixPath

import pytest

from running import BUILD, FILM, SOURCE, needs, needs_built, run

SPECIAL = {'intro/base/avx.h': r'.*intrin\.h', 'intro/base/wasm.h': r'wasm_simd128\.h', 'intro/base/gl.h': 'GL/.*',
           'intro/host/glfw.h': r'GLFW/glfw3\.h', 'intro/host/cpu.cpp': r'cpuid\.h'}  # system headers


@pytest.fixture(scope='module')
def tree():
    """The texts of the code, the CMakeLists.txt and the end-to-end tests."""
    names = run('git', 'ls-files', '-z', '--cached', '--others', '--exclude-standard', cwd=SOURCE).stdout.split('\0')
    wanted = [name for name in names if re.search(r'^tests/programs/|\.(h|cpp|c|S)$|/CMakeLists\.txt$', name)]
    return {name: (SOURCE / name).read_text(errors='replace') for name in wanted if (SOURCE / name).is_file()}


class House:
    """Compares all includes and links with the knows() lines. Tests may know every room, and no room may know tests."""

    def __init__(self, tree):
        self.knows, self.sources = defaultdict(set), defaultdict(set)
        self.links, self.includes, self.reached, self.wrong = [], [], {}, []
        for name, text in tree.items():
            if re.match('tests/|tools/film_template/', name):
                continue
            if name.endswith('/CMakeLists.txt'):
                self.read(name, re.sub('#.*', '', text))
            else:
                self.includes += [(name, found) for found in re.findall(r'^\s*#\s*include\s*(["<][^">]+)', text, re.M)]
        for room in sorted(self.knows):
            self.reach(room)
        for name, included in self.includes:
            judge = self.judge if included[0] == '"' else self.judge_system
            judge(name, included[1:])
        for link in self.links:
            self.judge_link(*link)

    def read(self, name, text):
        """Reads which rooms know which, and the sources and libraries of each target."""
        folder = PurePosixPath(name).parent
        for command, words in re.findall(r'^\s*(\w+)\(([^()]*(?:\([^()]*\)[^()]*)*)\)', text, re.M):
            first, *words = words.split() or ['']
            if command == 'knows':
                self.knows[first].update(words)
            elif command in ('add_library', 'add_executable', 'target_sources', 'host', 'engine_sources'):
                target = 'engine' if command == 'engine_sources' else first
                self.sources[target].update([name, *(folder / word for word in words if word.endswith('.cpp'))])
            elif command == 'target_link_libraries':
                self.links += [(name, first, word) for word in words]

    def reach(self, room, through=()):
        """All rooms that a room knows, itself or through others."""
        if room in through:
            self.wrong.append(f'{room} knows itself, by a circle')
            return set()
        if room not in self.reached:
            known = self.knows.get(room, set())
            for other in known:
                if not (SOURCE / other).exists() and not any(SOURCE.glob(f'{other}.*')):
                    self.wrong.append(f'{room} knows {other}, which does not exist')
            self.reached[room] = known.union(*(self.reach(other, (*through, room)) for other in known))
        return self.reached[room]

    def may(self, user, used):
        return user == used or used in self.reach(user)

    def room(self, name):
        """The room of a file: itself, with or without its ending, or the nearest folder with a knows() line."""
        path = PurePosixPath(name)
        places = map(str, (path, path.with_suffix(''), *path.parents))
        return next((place for place in places if place in self.knows), None)

    def judge(self, name, included):
        places = f'{PurePosixPath(name).parent}/{included}', included, f'intro/{included}', f'packer/{included}'
        found = next((place for place in places if (SOURCE / place).exists()), None)
        user = self.room(name)
        if found and not user:  # what does not exist is generated
            self.wrong.append(f'{name} belongs to no room')
        elif found and not (self.room(found) and (self.may(user, self.room(found)) or self.may(user, found))):
            self.wrong.append(f'{name} includes {found}')

    def judge_system(self, name, header):
        """The engine is freestanding: only host/linux, host/windows and what is not in the film use the system."""
        if not name.startswith('intro/') or re.match(r'intro/(maker/|record\.|main_debug\.|host/linux/)', name):
            return
        if not re.match(rf'(stddef\.h|stdint\.h|initializer_list|{SPECIAL.get(name, "")})$', header):
            self.wrong.append(f'{name} includes <{header}>')

    def judge_link(self, place, target, library):
        """A room with sources in the target must know a room with sources in the library."""
        users, used = ([*filter(None, map(self.room, self.sources[each]))] for each in (target, library))
        if users and self.sources[library] and not any(self.may(a, b) for a in users for b in used):
            self.wrong.append(f'{target} of {place} links {library}')


def test_every_include_and_every_link_goes_to_a_known_room(tree):
    house = House(tree)
    assert not house.wrong
    assert len(house.includes) >= 20 and len(house.links) >= 20


def arrows(tree):
    """The lines of knows() between the rooms that intro/README.md draws, as its arrows. Files of a room are labels."""
    page = (SOURCE / 'intro/README.md').read_text()
    drawn = set(re.findall(r'^    ([\w.]+) -->(?:\|([\w.]+)\|)? ([\w.]+)$', page, re.M))
    rooms, known = {room for user, _, used in drawn for room in (user, used)}, set()
    for user, others in House(tree).knows.items():
        for other in others:
            (_, a, *_), (_, b, *inside) = (PurePosixPath(name).parts + ('',) for name in (user, other))
            label = next((part for part in inside if part.endswith('.h')), '')
            if a != b and {a, b} <= rooms and user.startswith('intro/') and other.startswith('intro/'):
                known.add((a, label, b))
    return drawn, known


def test_the_graph_of_the_rooms_shows_what_they_know(tree):
    drawn, known = arrows(tree)
    assert drawn == known
    folders = {path.parent.name for path in SOURCE.glob('intro/*/CMakeLists.txt')}
    assert folders - {room for user, _, used in drawn for room in (user, used)} == {'maker'}
    planted = {**tree, 'packer/x/CMakeLists.txt': 'knows(intro/sound intro/timeline/track.h)'}
    assert arrows(planted)[1] - known == {('sound', 'track.h', 'timeline')}


@pytest.mark.parametrize('name, text, wrong', [
    *[(name, f'#include "{included}"', f'{name} includes {included}') for name, included in (
        ('intro/base/text.h', 'intro/host/files.h'),
        ('intro/trace/quality.h', 'intro/trace/scene/shape.h'),
        ('intro/host/files.h', 'intro/host/linux/sys.h'),
        ('intro/main.cpp', 'intro/maker/screen.h'),
        ('packer/main.cpp', 'intro/base/text.h'),
        ('packer/model/search.cpp', 'packer/stub/format.h'),
        ('tools/support/machine.cpp', 'tools/radiosity/read/mesh.h'),
        ('tools/radiosity/read/mesh.h', 'tools/radiosity/solution/solution.h'),
        ('tools/picture/flip.cpp', 'tests/support/dice.h'))],
    ('intro/show/hall.cpp', '#include <GL/gl.h>', 'intro/show/hall.cpp includes <GL/gl.h>'),
    ('intro/trace/picture/frame.cpp', '#include <vector>', 'intro/trace/picture/frame.cpp includes <vector>'),
    ('intro/new.cpp', '#include "intro/base/text.h"', 'intro/new.cpp belongs to no room'),
    ('packer/x/CMakeLists.txt', 'knows(intro/base intro/play)', 'intro/base knows itself, by a circle'),
    ('packer/x/CMakeLists.txt', 'knows(packer intro/none)', 'packer knows intro/none, which does not exist'),
    ('packer/x/CMakeLists.txt', 'host(x y.cpp)\ntarget_link_libraries(x play)',
     'x of packer/x/CMakeLists.txt links play')])
def test_a_planted_breach_would_be_found(tree, name, text, wrong):
    assert wrong in House({**tree, name: text}).wrong


def unlike_others(tree):
    """The end-to-end tests' files that are long, have long lines or are in other languages."""
    usual = r'tests/programs/.*(\.(mjs|js|cpp|h|cmake|py)|\b(CMakeLists\.txt|pytest\.ini))$'
    tests = {name: text for name, text in tree.items() if name.startswith('tests/programs/')}
    return [name for name, text in tests.items() if not re.match(usual, name) or re.search('.{121}', text)
            or name.endswith('.py') and text.count('\n') > 250]


def test_end_to_end_tests_are_short_files_of_python(tree):
    assert not unlike_others(tree)
    for name, width, lines in ('x.sh', 1, 1), ('web/x.pl', 1, 1), ('x.py', 121, 1), ('x.py', 1, 251):
        planted = f'tests/programs/{name}'
        assert unlike_others({planted: lines * (width * 'x' + '\n')}) == [planted]


@pytest.mark.parametrize('tool', 'watch test golden ledger new-film release render'.split())
def test_a_tool_does_not_depend_on_the_environment_of_its_caller(tool, tmp_path):
    (tmp_path / 'env').write_text('cd() { echo /none; }\nexport -f cd\n')
    (tmp_path / 'git').write_text('#!/bin/bash\ntype -t pwd >"$0.pwd"\n')  # stands for all child shells
    (tmp_path / 'git').chmod(0o755)
    odd = {'CDPATH': '.:/tmp', 'SHELLOPTS': 'noclobber:noglob', 'BASHOPTS': 'failglob', 'BASH_ENV': tmp_path / 'env',
           'BASH_FUNC_pwd%%': '() { echo /none; }', 'GIT_DIR': '/none', 'PATH': f'{tmp_path}:{os.environ["PATH"]}'}
    assert run(f'tools/{tool}', '-h', cwd=SOURCE, env=odd).stdout == run(f'tools/{tool}', '--help', cwd=SOURCE).stdout
    assert (tmp_path / 'git.pwd').read_text() == 'builtin\n'


def dead_links(pages):
    links = [(page, link) for page in pages for link in re.findall(r'\]\((?!https?:)([^)#]+)', page.read_text())]
    assert links
    return [f'{page}: {link}' for page, link in links if not (page.parent / link).exists()]


def unlike_layout(*names, folder=SOURCE):
    printed = run('clang-format-14', '--dry-run', *names, cwd=folder).stderr
    return set(re.findall('^(.*?):.*code should be clang-formatted', printed, re.M))


def test_line_ends_do_not_depend_on_settings_of_git_and_code_has_the_layout_of_clang_format(tmp_path):
    names = run('git', 'ls-files', '--eol', cwd=SOURCE).stdout
    assert not re.findall(r'^(?!i/(?:lf|none) .*attr/text=auto eol=lf|i/-text .*attr/-text).+', names, re.M)
    run('git', 'grep', '-IP', '\t| $', status=1, cwd=SOURCE)  # no tab, and no space at the end of a line
    needs('clang-format-14')
    assert not unlike_layout(*run('git', 'ls-files', '*.c', '*.cpp', '*.h', cwd=SOURCE).stdout.splitlines())
    (tmp_path / 'x.cpp').write_text('int  x;\n')
    assert unlike_layout('x.cpp', folder=tmp_path) == {'x.cpp'}


def test_the_top_level_has_only_what_readers_look_for_and_pages_no_dead_links(tmp_path):
    names = run('git', 'ls-files', cwd=SOURCE).stdout.splitlines()
    assert {name.split('/')[0] for name in names} == set(
        'CMakeLists.txt LICENSE README.md intro packer tests tools .ci .clang-format .devcontainer .editorconfig '
        '.gitattributes .github .gitignore'.split())
    assert [name for name in names if 'LICENSE' in name] == ['LICENSE']
    assert not dead_links(SOURCE / name for name in names if re.match(r'(?!tools/film_template/).*\.md$', name))
    page = tmp_path / 'wrong.md'
    page.write_text('[a](nothing.md)')
    assert dead_links([page]) == [f'{page}: nothing.md']


def test_the_film_is_made_of_intro_and_packer_and_what_the_packer_knows():
    needs('ninja')
    needs_built('build.ninja')
    inputs = run('ninja', '-C', BUILD, '-t', 'inputs', FILM, f'{FILM}-safe').stdout.replace(f'{SOURCE}/', '')
    assert 'intro/main.cpp' in inputs.splitlines()
    assert not re.search('^(tests/|tools/(?!common/|build/))', inputs, re.M)


def unregistered(tree):
    """The test files that CMake does not name with one of their kinds."""
    lists = ''.join(text for name, text in tree.items() if re.match(r'tests/programs/(fuzz/)?[\w.]+(?<!py)$', name))
    words = set(re.findall(r'\w+', re.sub('#.*', '', lists)))
    return [name for name in tree if (found := re.match(r'tests/programs/(test_(\w+)\.py)$', name))
            and not {found[2], found[1][:-3]} & words]


def test_ctest_runs_every_test_file(tree):
    assert not unregistered(tree)
    assert unregistered({**tree, 'tests/programs/test_new.py': ''}) == ['tests/programs/test_new.py']
