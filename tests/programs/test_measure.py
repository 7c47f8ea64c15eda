"""tools/measure/all measures, and writes RESULTS.md. What its --check prints is tested in a scratch repository with two
sections that take no time."""
import itertools
import re
import shutil
import sys

import pytest

from running import BUILD, SOURCE, Repository, needs, needs_built, number, refuses, run

needs('python3', 'git', 'objcopy', 'g++', 'ninja')
needs_built('odraz')

ALL = SOURCE / 'tools/measure/all'
FRESH = '2 sections, 0 of them stale'
sys.path.append(str(ALL.parent))
import methods  # noqa: E402 (its folder is known now)


@pytest.fixture(scope='module')
def page(work):
    """A page of which one section was measured."""
    page = work / 'results.md'
    progress = run(ALL, '--built', '--to', page, '--only', 'size', env={'BUILD': BUILD}).stderr
    assert 'measuring size, 1 of 1: 0.1 minutes' in progress.splitlines()
    return page


def test_a_measured_section_has_its_commit_its_command_and_its_figures_and_all_sections_are_there(page):
    commit = run('git', 'rev-parse', '--short=12', 'HEAD', cwd=SOURCE).stdout.strip()
    command = 'By `cmake --build build --target film film_windows`:'
    assert re.search(rf'^<!-- size: {commit}\+?; intro .*\n## .*\n\n.*{command}$', page.read_text(), re.M)
    used = number(r'^"file": (.*),', (BUILD / 'odraz-windows.json').read_text())
    assert f'| `odraz`: packed | {(BUILD / "odraz").stat().st_size} | {used:.0f} |' in page.read_text()
    sections = run(ALL, '--list').stdout.splitlines()
    assert page.read_text().count('\n## ') == len(sections)
    assert sum(float(section.split()[1]) for section in sections) <= 25  # minutes
    assert 'Not measured yet: `tools/measure/all --only packers`' in page.read_text()


def test_a_section_that_fails_is_reported_and_leaves_the_results_alone(page, work):
    before = page.read_text()
    failed = run(ALL, '--built', '--to', page, '--only', 'size', env={'BUILD': work / 'none'}, status=1)
    assert 'not changed: size' in failed.stderr
    assert page.read_text() == before


def test_all_sources_are_there_and_the_readme_has_the_figures_of_the_results():
    printed = run(ALL, '--check', env={'BUILD': BUILD}, status=None).stdout
    assert printed and not re.search('^(unknown|the figures|figures)', printed, re.M)


def test_figures_are_read_from_reports_of_tests_and_a_test_without_any_is_an_error():
    named = {'classname': 'Hall', 'line': 7, 'time': '0.1s'}
    tests = [{**named, 'name': 'IsRight', 'rms': '0.0011623 <= 0.002'}, {**named, 'name': 'IsLit'}]
    report = {'testsuites': [{'testsuite': tests}]}
    right = {'test': 'Hall.IsRight', 'what': 'rms', 'figure': '0.00116', 'limit': '0.002'}
    assert list(methods.recorded(report, ['Hall.IsRight'])) == [right]
    for name in 'Hall.IsLit', 'Hall.IsGone':
        with pytest.raises(methods.Failed, match=f'{name} recorded no figure'):
            list(methods.recorded(report, ['Hall.IsRight', name]))


def test_tests_whose_figures_are_shown_record_them():
    sources = ''.join(path.read_text() for path in (SOURCE / 'tests/unit').rglob('*_test.cpp'))
    for name in itertools.chain(*methods.PROOFS.values()):
        body = re.search(rf"TEST\({name.replace('.', ', ')}\) {{\n(.*?)\n}}", sources, re.S)
        assert body and 'expect' in body[1], name


@pytest.mark.parametrize('text, options', [
    ("unknown section 'colour': use one of size", ['--only', 'colour']),
    ('unrecognized arguments: --colour: see tools/measure/all --help', ['--colour']),
    ('cannot write /proc/none/x', ['--to', '/proc/none/x'])])
def test_refuses(text, options):
    refuses(2, text, ALL, *options)


# --- What --check prints ---

class Scratch(Repository):
    """A repository with two sections. A program is built from the first one's source."""

    def all(self, *options, **more):
        env = {'BUILD': self.folder / 'build', 'GIT_DIR': '/none'}
        return run(self.folder / 'tools/measure/all', *options, env=env, **more)

    def reports(self, status, line, *options):
        __tracebackhide__ = True
        assert line in self.all('--check', *options, status=status).stdout.splitlines()

    def compile(self):
        run('ninja', '-C', self.folder / 'build')

    def changed(self, section, source):
        return f'stale: {section}: changed since {self.git("rev-parse", "--short=12", "HEAD")}: {source}'


@pytest.fixture(scope='module')
def unmeasured(work):
    scratch = Scratch(work / 'unmeasured')
    scratch.write('README.md', 'A film.\n<!-- figures -->\nBalls: 7 ms.\n<!-- /figures -->\nMore.\n')
    scratch.write('intro/file.cpp', 'int main() { int one = 1; return one - 1; }\n')
    scratch.write('packer/file', '1\n')
    scratch.write('.gitignore', 'build\n')
    scratch.write('build/build.ninja',
                  'rule cc\n  command = g++ -O1 $in -o $out\nbuild program: cc ../intro/file.cpp\n')
    tools = scratch.folder / 'tools/measure'
    (scratch.folder / 'tools/build').mkdir(parents=True)
    tools.mkdir()
    for name in 'all', 'machine.py', 'parts.py', 'results.py', 'sources.py', 'figures.py':
        shutil.copy(SOURCE / 'tools/measure' / name, tools)
    shutil.copy(SOURCE / 'tests/support/measure/sections.py', tools)
    scratch.compile()
    scratch.commit('.')
    return scratch


@pytest.fixture(scope='module')
def measured(unmeasured, work):
    Scratch(shutil.copytree(unmeasured.folder, work / 'measured')).all('--built')
    return work / 'measured'


@pytest.fixture
def scratch(measured, tmp_path):
    """A copy in which both sections are measured."""
    return Scratch(shutil.copytree(measured, tmp_path / 'copy'))


def test_what_was_measured_is_fresh_also_with_other_comments_and_prose(scratch, unmeasured):
    unmeasured.reports(1, 'unmeasured: two: run tools/measure/all --only two, 1 minutes')
    scratch.reports(0, FRESH, '--strict')
    readme = (scratch.folder / 'README.md').read_text()
    assert readme == 'A film.\n<!-- figures -->\nBalls: 1,235 ms.\n<!-- /figures -->\nMore.\n'
    scratch.write('intro/file.cpp', 'int main() { /* its status */ int one = 1; return one - 1; } // no more\n')
    scratch.write('intro/README.md', 'text\n')
    scratch.write('packer/file', '1\n# why\n')
    scratch.reports(0, FRESH, '--strict')


def test_a_local_variables_name_makes_its_section_stale_until_the_program_is_built(scratch):
    scratch.write('intro/file.cpp', 'int main() { int two = 1; return two - 1; }\n')
    scratch.reports(0, scratch.changed('one', 'intro'))
    scratch.compile()
    scratch.reports(0, FRESH, '--strict')


def test_other_code_makes_its_section_stale_until_it_is_measured(scratch):
    scratch.write('intro/file.cpp', 'int main() { int two = 7; return two - 1; }\n')
    scratch.compile()
    scratch.reports(0, '2 sections, 1 of them stale')
    scratch.reports(1, scratch.changed('one', 'intro'), '--strict')
    progress = scratch.all('--built', '--stale').stderr
    assert len(re.findall('^measuring', progress, re.M)) == 1
    scratch.reports(0, FRESH, '--strict')
    scratch.write('packer/file', '1\n2\n')  # a script's code, whatever was built
    scratch.reports(0, scratch.changed('two', 'packer/file'))


def test_wrong_figures_are_reported_and_written_again_and_a_missing_source_is_reported(scratch):
    readme = (scratch.folder / 'README.md').read_text()
    scratch.write('README.md', readme.replace('1,235', '1,234'))
    scratch.reports(1, 'the figures of README.md differ from RESULTS.md: run tools/measure/all --readme')
    scratch.all('--readme')
    scratch.reports(0, FRESH, '--strict')
    sections = (scratch.folder / 'tools/measure/sections.py').read_text()
    scratch.write('tools/measure/sections.py', sections.replace('packer/file', 'packer/none'))
    scratch.reports(1, 'unknown: two needs packer/none, which git does not have')
