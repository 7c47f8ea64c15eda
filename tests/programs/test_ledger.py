"""tools/ledger prints the tables of rooms and of lines, and fails for a tree over its budget of lines."""
import json
import re
import shutil

from running import SOURCE, Repository, refuses, run

LEDGER, ENVIRONMENT = SOURCE / 'tools/ledger', SOURCE / 'tools/build/environment.sh'


def rooms(folder, trace):
    """The table, and stderr, for a film of two objects. The second, in the room trace, takes so many bytes."""
    objects = {'main.cpp.o': {'bytes': 300, 'bits': 800}, 'sky.cpp.o': {'bytes': 9000, 'bits': trace * 8}}
    report = {'file': 2600 + trace, 'overhead': 2500, 'objects': objects}
    (folder / 'odraz.json').write_text(json.dumps(report))
    (folder / 'odraz-windows.json').write_text('"file": 65000,\n')
    result = run(LEDGER, 'rooms', env={'BUILD': folder})
    return result.stdout, result.stderr


def has_row(pattern, table):
    return re.search(f'^{pattern}', re.sub(' +', ' ', table), re.M)


def test_rooms_that_keep_to_their_shares_are_listed_and_every_folder_of_the_engine(tmp_path):
    table, errors = rooms(tmp_path, 4000)
    assert has_row('trace 4000 ', table)
    assert has_row('intro 100 ', table)
    before = json.loads((SOURCE / 'intro/size_ledger.json').read_text())['file']
    assert has_row(f'the film 6600 65536 58936 {6600 - before}$', table)
    assert has_row(r'the \.exe 65000 65536 536$', table)
    assert errors == ''
    folders = {path.relative_to(SOURCE / 'intro').parts[0] for path in SOURCE.glob('intro/*/**/*.cpp')}
    assert folders - {line.split()[0] for line in table.splitlines()} == {'maker'}  # which is not in the film


def test_a_room_over_its_share_is_reported_and_a_film_that_is_not_built_refused(tmp_path):
    table, errors = rooms(tmp_path, 40000)
    assert has_row('trace 40000 .*more than its share$', table)
    assert 'trace is over its share' in errors
    refuses(1, 'build film and pack first', LEDGER, 'rooms', env={'BUILD': tmp_path / 'none'})


class House(Repository):
    """A repository of two rooms and other files, which has nine lines fewer than its budget."""

    def __init__(self, folder):
        super().__init__(folder)
        self.budget = 2 + 4 + 3 + 10 + 1 + 1 + (LEDGER.read_text() + ENVIRONMENT.read_text()).count('\n') + 9
        self.write('.ci/run', 2 * '\n')
        self.write('intro/main.cpp', 4 * '\n')
        self.write('tests/unit.cpp', 3 * '\n')
        self.write('intro/trace/trace.cpp', 10 * '\n')
        self.write('intro/film.conf', 'FILM=odraz\n')
        self.write('tools/build/line_budget', f'{self.budget}\n')
        shutil.copy(LEDGER, folder / 'tools')
        shutil.copy(ENVIRONMENT, folder / 'tools/build')
        self.commit('.')

    def lines(self, status=0):
        result = run('tools/ledger', 'lines', cwd=self.folder, status=status, env={'GIT_DIR': '/none'})
        return result.stdout, result.stderr


def test_lines_are_listed_with_their_changes_and_the_budget(tmp_path):
    house = House(tmp_path)
    table, errors = house.lines()
    assert has_row(r'intro 4 0 1 0 5 \+0$', table)
    assert has_row(f'budget {house.budget}, left 9$', table)
    assert errors == ''
    assert run('tools/ledger', 'lines', cwd=house.folder, env={'GIT_TRACE': '1'}).stdout == table
    refuses(1, "there is no commit 'colour'", 'tools/ledger', 'lines', 'colour', cwd=house.folder)
    # Pictures, models, data, texts and untracked files do not count
    for ending in 'svg jpg exr gltf glb obj mtl csv bin keys md nfo diz'.split():
        house.write(f'intro/trace/file.{ending}', 20 * '\n')
    house.write('LICENSE', 20 * '\n')
    house.git('add', '-A')
    house.write('intro/trace/run', 9 * '\n')
    assert has_row(r'intro/trace 10 0 0 60 10 \+0$', house.lines()[0])


def test_a_tree_may_fill_its_budget_but_not_exceed_it(tmp_path):
    house = House(tmp_path)
    house.write('intro/trace/run', 9 * '\n')
    house.git('add', '-A')
    assert has_row(r'intro/trace 10 0 9 0 19 \+9$', house.lines()[0])
    house.write('intro/trace/run', 10 * '\n')
    table, errors = house.lines(status=1)
    assert table.endswith('left -1\n')
    assert errors.startswith(f'ledger: the tree has {house.budget + 1} lines, its budget is {house.budget}: ')
