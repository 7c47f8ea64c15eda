"""The film's page in Chromium, Firefox and WebKit: golden pictures, music, and playing. Its player is also tested
alone, on a simulated clock, with a stated time for each picture."""
import functools
import re

import pytest

from displays import Display
from recordings import Server
from running import BUILD, CONF, FILM, PATIENCE, SOURCE, check_bytes, needs, needs_built, refuses, run

needs('node')
needs_built(f'{FILM}.html')
PAGE, HOST = BUILD / f'{FILM}.html', BUILD / 'intro/host/web'
PROGRAM, SCRIPTS = HOST / f'{FILM}.wasm', SOURCE / 'intro/host/web'
TESTS, GOLDEN = SOURCE / 'tests/programs/web', SOURCE / 'tests/golden'
LIT, TRACED = CONF['FILM_LIT'].split(), CONF['FILM_TRACED'].split()
ALL = LIT + TRACED
# WebKit draws all golden pictures, the others every second one, and all of them the first in the hall
MOMENTS = {'chromium': ALL[:1] + ALL[1::2], 'firefox': ALL[::2], 'webkit': ALL}
PROGRAMS = {'chromium': 'chromium', 'firefox': 'firefox-esr', 'webkit': 'WebKitWebDriver'}


def is_golden(picture, *options, golden=None):
    """Asserts that a picture SECOND.ppm equals the golden one, or another one."""
    run(BUILD / 'compare', golden or GOLDEN / f'film-{picture.stem:0>3}.png', picture, *options)


def test_plays_in_a_simulated_browser():
    scripts = (SCRIPTS / f'{name}.js' for name in ('plain', 'pictures', 'music', 'page'))
    run('node', TESTS / 'player.mjs', PROGRAM, *scripts)


def test_over_budget_it_is_not_made_and_it_has_a_language_and_says_that_it_needs_scripts(tmp_path):
    sources = (SCRIPTS / name for name in ('page.model', 'page.html', 'worker.js', 'page.js'))
    refuses(1, 'over budget by ', BUILD / 'page', PROGRAM, HOST / 'decode.wasm', *sources, tmp_path / 'over.html', 9)
    before, comment, after = PAGE.read_bytes().partition(b'<!--')
    assert b'<html lang=en>' in before and before.endswith(b'<noscript>This film needs JavaScript.</noscript>')
    text = re.search(b'<!--(.*?)--><script>', comment + after, re.S)[1]
    assert len(text) > 50000
    assert not re.search(b'[\0\r]|[-!]>', b'-' + text)  # HTML keeps the bytes of the comment, and all of it


@pytest.fixture(scope='module')
def plain(work):
    """A folder with the pictures that browsers without relaxed SIMD draw."""
    folder = work / 'plain'
    folder.mkdir()
    run('node', TESTS / 'plain.mjs', PROGRAM, SCRIPTS / 'plain.js', folder, *TRACED)
    return folder


@pytest.mark.parametrize('second', TRACED)
def test_plain_simd_draws_almost_golden_pictures(plain, second):
    is_golden(plain / f'{second}.ppm', '--psnr', 65)


@pytest.fixture(scope='module')
def visit(work):
    """visit(BROWSER) uses the page in a browser once. Returns the folder of what it drew, and the ended process."""
    with Display('1280x800') as screen:
        Server(screen)  # in WebKit the clock of a sound stands still without one
        screen.env['TMPDIR'] = screen.folder  # for the browsers' profiles

        @functools.cache
        def visit(browser):
            needs(PROGRAMS[browser])
            folder = work / browser
            folder.mkdir()
            command = ('node', TESTS / 'page.mjs', browser, PAGE, folder, *MOMENTS[browser])
            return folder, screen.run('timeout', PATIENCE, *command, status=None, timeout=None)
        yield visit


@pytest.mark.parametrize('browser', MOMENTS)
def test_works_in_a_browser(visit, browser):
    _, used = visit(browser)
    status, output = used.returncode, used.stdout + used.stderr
    assert status == 0, output


@pytest.mark.parametrize('browser, second', [(browser, second) for browser in MOMENTS for second in MOMENTS[browser]])
def test_a_browser_draws_golden_pictures(visit, plain, browser, second):
    folder, _ = visit(browser)
    picture = folder / f'{second}.ppm'
    if second in LIT:
        is_golden(picture, '--psnr', 50)  # rays find the hall's light, not OpenGL
    elif (folder / 'plain').exists():
        is_golden(picture, golden=plain / picture.name)
    else:
        is_golden(picture)


def test_chromium_makes_the_golden_music_and_draws_the_same_hall_as_firefox(visit):
    chromium, _ = visit('chromium')
    assert (chromium / 'music.sha256').read_text() == (GOLDEN / 'music.sha256').read_text()
    firefox, _ = visit('firefox')
    check_bytes(*((folder / f'{LIT[0]}.ppm').read_bytes() for folder in (chromium, firefox)))
