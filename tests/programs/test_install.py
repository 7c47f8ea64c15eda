"""cmake --install puts the film, the tools and their READMEs under a prefix, and each program runs there."""
import re

import pytest

from running import BUILD, FILM, SOURCE, needs, needs_built, run

needs('cmake')
needs_built(FILM, 'pack', 'compare', 'radiosity')


@pytest.fixture(scope='module')
def prefix(work):
    run('cmake', '--install', BUILD, '--prefix', work / 'prefix')
    return work / 'prefix'


def test_each_program_has_a_help(prefix):
    programs = {path.name: path for path in (prefix / 'bin').iterdir()}
    assert programs.keys() == {FILM, f'{FILM}-safe', 'pack', 'compare', 'radiosity'}
    for program in programs.values():
        assert re.search('^[Uu]sage: ', run(program, '--help').stdout, re.M)


def test_pack_makes_a_program_that_runs(prefix, tmp_path):
    assert 'bytes left' in run('bash', SOURCE / 'packer/example/build.sh', prefix / 'bin/pack', tmp_path).stdout
    hello = run(tmp_path / 'hello', status=7)
    assert (hello.stdout.rstrip(), hello.stderr) == ('hello, 1 words, 42', '')


def test_radiosity_solves(prefix, tmp_path):
    run(prefix / 'bin/radiosity', 'generate', 'cube', '-o', 'cube.obj', cwd=tmp_path)
    run(prefix / 'bin/radiosity', 'solve', 'cube.obj', '-o', 'cube.rad', cwd=tmp_path)


def test_texts_are_there_and_nothing_else(prefix):
    for text in 'pack/README.md', 'radiosity/README.md', 'radiosity/METHOD.md', 'CI.md', 'LICENSE':
        assert (prefix / 'share/doc' / FILM / text).stat().st_size
    assert {path.name for path in prefix.iterdir()} == {'bin', 'share'}
