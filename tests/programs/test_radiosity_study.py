"""radiosity study --quick: the page, its numbers, a command on it, and interrupts. Its figures are the same on every
machine and at any load."""
import os
import re
import shutil
from pathlib import Path

import pytest

from radiosity_runs import RADIOSITY, generate, interrupted_at, radiosity
from running import Program, needs, refuses, rows_of, run, wait_for

pytestmark = pytest.mark.usefixtures('page')


@pytest.fixture(scope='module')
def page(in_work):
    """The study of a cube."""
    generate('cube', 'cube.obj')
    assert radiosity('study', 'cube.obj', '-o', 'page', '--quick').stdout == 'page/index.html: 10 solutions\n'


def column(table, name, **wanted):
    """A column of a table on the page, of the rows whose cells begin as wanted."""
    rows = [row for row in rows_of(f'page/{table}.csv') if all(str(row[key]).startswith(wanted[key]) for key in wanted)]
    return [row[name] for row in rows]


# --- The page ---
def parts_of(folder):
    """The files of a page: itself, and those that it shows or links to."""
    return {'index.html', *re.findall('(?:src|href)="(.*?)"', Path(folder, 'index.html').read_text())}


def test_the_page_has_all_its_parts_and_nothing_else():
    assert parts_of('page') == set(os.listdir('page'))
    assert len(parts_of('page')) > 25


def test_the_page_needs_no_network():
    for page in Path('page').glob('*.html'):
        assert not re.search(r'(https?:)?//[a-z]|@import|url\(', page.read_text())


def test_the_page_and_its_plots_are_well_formed():
    needs('xmllint')
    run('xmllint', '--noout', 'page/index.html', *Path('page').glob('*.svg'))


def test_tables_have_numbers():
    for table in Path('page').glob('*.csv'):
        assert rows_of(table)


# --- Figures ---
def test_the_light_so_far_and_the_light_that_is_left_add_up():
    so_far = 0
    for added, left in zip(column('passes', 'added_next_percent'), column('passes', 'left_next_percent')):
        so_far += added
        assert so_far + left == pytest.approx(100, abs=1)


# Each pass reflects the light of the last one in the same room, which reflects about half
def test_a_pass_adds_about_half_of_the_one_before():
    added = column('passes', 'added_next_percent')
    for k in range(2, 10):
        assert 0.45 <= added[k] / added[k - 1] <= 0.6


def test_new_light_used_at_once_halves_the_passes():
    once, later = (column('orders', f'passes_{name}', error_percent='0.01') for name in ('once', 'next'))
    assert once[0] <= 0.6 * later[0]


@pytest.mark.parametrize('method, limit', [
    ('gathering', 0.01), ('Gauss-Seidel', 0.01), ('shooting over', 0.01),
    # It uses the form factors of the other direction, which differ where hemicubes are coarse
    ('shooting by hemicubes, single', 10),
])
def test_methods_converge_to_the_same_light(method, limit):
    assert column('methods_within', 'last_error_percent', method=method)[0] < limit


def test_more_pixels_of_a_hemicube_have_smaller_errors():
    one, four = ({row['px']: row['from_finest_percent'] for row in rows_of('page/gathering.csv')
                  if row['hemicubes'].startswith(kind)} for kind in ('one', 'four rotated'))
    assert one[100] < one[25] / 3
    assert one[50] < four[25], 'one hemicube is not better than four with as many pixels'
    whole = column('rasters', 'rms_percent')
    assert len(whole) == 4 and whole == sorted(set(whole), reverse=True)


def test_interpolated_light_has_at_most_half_the_error_of_flat_light():
    flat, interpolated = (column('display', 'rms_percent', shown=kind)[0] for kind in ('flat', 'interpolated'))
    assert interpolated < flat / 2


def test_smaller_patches_and_finer_rasters_have_smaller_errors():
    coarse, fine_raster, small, both = column('table', 'median_percent')
    assert both < fine_raster < coarse and both < small < coarse


def test_the_default_solution_is_measured_and_no_coarse_one_has_a_smaller_error():
    errors = {row['solution']: row['rms_percent'] for row in rows_of('page/front.csv')}
    best = min(errors, key=errors.get)
    assert best.endswith(' elements, by rays')
    assert column('front', 'command', solution=best) == ['radiosity solve cube.obj -o OUT.rad']


def test_the_reference_was_compared_with_path_tracing():
    assert re.search(r'The reference itself differs from path tracing, .*, by (less than )?[0-9.]+ % '
                     r'\(rms; median [0-9.]+ %\)', Path('page/index.html').read_text())


def test_a_command_on_the_page_repeats_its_solution():
    row = next(row for row in rows_of('page/solutions.csv') if ', shot by ' in row['solution'])
    _, *words = row['command'].replace('OUT.rad', 'followed.rad').split()
    patches = row['solution'].split(',')[0]
    assert re.search(rf'\b{patches}', radiosity(*words).stdout), f'{words} has not {patches}'


# --- Interrupts and errors ---
def interrupt(chapter, line, folder):
    """Interrupts a study in a chapter. It is tried again where the next chapter had begun: then the line differs."""
    def interrupted():
        shutil.rmtree('x', ignore_errors=True)
        with Program(folder, RADIOSITY, 'study', 'cube.obj', '-o', 'x', '--progress', '--quick') as study:
            status = interrupted_at(f'progress: {chapter}.* %', study, study.errors)
            return status and f'\nradiosity: {line}\n' in study.errors() and not Path('x/rasters.csv').exists()
    wait_for(interrupted)


def test_an_interrupt_during_the_reference_leaves_nothing(tmp_path):
    interrupt('reference', 'interrupted: no page is written', tmp_path)
    assert not list(Path().glob('x*'))


def test_an_interrupt_during_the_table_leaves_the_chapters_that_are_done(tmp_path):
    interrupt('table', 'interrupted: x/index.html has what was measured until then', tmp_path)
    assert Path('x/methods.csv').read_text()
    assert parts_of('x') == set(os.listdir('x'))
    assert '<li>rasters: interrupted' in Path('x/index.html').read_text()


def test_refuses_a_folder_that_is_not_empty():
    refuses(2, 'page: already exists', RADIOSITY, 'study', 'cube.obj', '-o', 'page', '--quick')
