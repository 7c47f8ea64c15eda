"""The page of tools/ledger pack --html in a browser: it opens, adds up, answers mouse and keys, shows the same
instructions as objdump, and prints nothing on its console."""
import re

import pytest

from pictures import numpy, read_picture
from report_pages import adds_up
from running import BUILD, SOURCE, needs, number, run

pytestmark = pytest.mark.long
needs('chromium', 'objdump', 'convert', 'perl')


def ledger(*options):
    return run(SOURCE / 'tools/ledger', 'pack', *options, env={'BUILD': BUILD}).stdout


@pytest.fixture(scope='module')
def page(work):
    ledger('--html', work / 'film.html', '--than', SOURCE / 'intro/size_ledger.json')
    return work / 'film.html'


@pytest.fixture
def browse(tmp_path):
    """browse(PAGE, OPTION...) opens a page without a network, and returns what chromium prints. The page may print
    nothing on its console."""
    def browse(page, *options):
        result = run('chromium', '--headless', '--no-sandbox', '--disable-gpu', '--enable-logging=stderr',
                     f'--user-data-dir={tmp_path}/profile', '--host-resolver-rules=MAP * ~NOTFOUND',
                     '--window-size=1400,1440', '--virtual-time-budget=60000', *options, f'file://{page}')
        assert not re.search('.*:CONSOLE.*', result.stderr, re.I)
        return result.stdout
    return browse


def test_the_page_adds_up_and_is_small(page):
    _, instructions = adds_up(page)
    assert 10000 <= instructions < 100000
    assert page.stat().st_size <= 640 * 1024


def test_the_page_opens(page, browse):
    assert 'data-ready="yes"' in browse(page, '--dump-dom')


def test_the_page_answers_mouse_and_keys_and_shows_what_objdump_does(page, browse, tmp_path):
    script = (SOURCE / 'tests/programs/report/poke.js').read_text()
    poked = tmp_path / 'poked.html'
    poked.write_text(page.read_text().replace('</body>', f'<script>{script}</script></body>', 1))
    dom = browse(poked, '--dump-dom')
    assert re.search('data-failed="([^"]*)"', dom)[1] == ''
    assert number('data-checked="([0-9]+)"', dom) >= 30

    code = run(*'objdump -d -w -z -M intel --no-show-raw-insn'.split(), BUILD / 'odraz.elf').stdout
    lines = re.findall(r'^ *([0-9a-f]+):\t(.*)', code, re.M)
    # without objdump's symbols
    wanted = [re.sub('  +', ' ', re.sub(' *<.*', '', f'{address} {text}')).rstrip() for address, text in lines]
    shown = re.search('<pre class="instructions">(.*?)</pre>', dom, re.S)[1].splitlines()
    assert len(shown) == len(wanted) > 20000
    assert not sorted(set(shown) ^ set(wanted))[:5]


@pytest.mark.parametrize('size', ['1400,1440', '500,900'])
def test_the_page_is_drawn(size, page, browse, tmp_path):
    browse(page, '--hide-scrollbars', f'--window-size={size}', f'--screenshot={tmp_path}/page.png')
    colours = numpy.unique(read_picture(tmp_path / 'page.png').reshape(-1, 3), axis=0)
    assert len(colours) > 500


def test_a_damaged_page_shows_an_error(page, browse, tmp_path):
    damaged = tmp_path / 'damaged.html'
    damaged.write_text(re.sub('(id="tables">.{5000}).', r'\1!', page.read_text(), count=1))
    assert 'This page cannot be shown' in browse(damaged, '--dump-dom')


# The comment on a change
def test_the_film_is_the_same_as_itself():
    text = ledger('--text', '-', '--than', BUILD / 'odraz.json')
    assert re.search(r'^\*\*`odraz`: [0-9,]+ bytes\*\*, \+0 .* left of 65,536$', text, re.M)
    assert re.search(r'^No symbol changed by four bytes or more\.$', text, re.M)
