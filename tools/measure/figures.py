"""The figures in README.md. The lines between its marks are generated from cells of RESULTS.md, so README.md has no
figure that RESULTS.md lacks."""
import re

from machine import Failed

BLOCK = re.compile(r'(?<=^<!-- figures -->\n).*?(?=^<!-- /figures -->$)', re.S | re.M)


def number(text):
    return float(re.match(r'[-+0-9.]+', text)[0])


def rounded(text, digits=0):
    return f'{number(text):,.{digits}f}'


def least_to_most(texts, digits):
    """The range of the numbers at the start of cells: '3 to 7'."""
    numbers = [number(text) for text in texts if re.match(r'[-+]?\d', text)]
    return f'{min(numbers):,.{digits}f} to {max(numbers):,.{digits}f}'


def figures(results):
    cell = results.cell

    def span(section, column, digits=0):
        return least_to_most(results.column(section, column).values(), digits)

    def all_scenes(screen):
        return number(cell('play', 'all', screen))

    def page_seen(machine):
        return number(cell('page', 'all', str(machine)))
    packed, linked = '`odraz`: packed', '`odraz-safe`: linked and stripped'
    peer = 'POV-Ray +AM2 +A0.1 +R3'

    def solved(model):
        return (f"{rounded(cell('radiosity', 'odraz, s', model), 1)} s, "
                f"{rounded(cell('radiosity', 'rms, %', model), 1)} %")
    opens = results.column('page', 's until the page is there')
    first = results.column('page', 's from the click to the first picture')
    loads = [f"{name.title().replace('kit', 'Kit')} {number(opens[name]) + number(first[name]):.1f} s"
             for name in opens]
    shown = [rate for name in opens for rate in results.column('page', f'{name}: shown a second').values()]
    flips, times = (results.cells('peers', column, peer, 2) for column in ('mean FLIP', 'times at equal FLIP'))
    return f'''\
- **Size:** {rounded(cell('size', 'Linux', packed))} bytes of 65,536, for Windows \
{rounded(cell('size', 'Windows', packed))} used, packed from {rounded(cell('size', 'Linux', linked))}: code to \
{span('packers', 'to xz', 2)} of `xz -9e`.
- **Start:** the window after {rounded(cell('start', 'seconds until its window is seen', '`odraz`'), 1)} s, the first \
picture after {rounded(cell('start', 'until the first picture', '`odraz`'), 1)} s, with the hall solved; \
{cell('start', 'MB resident at most', '`odraz`')} MB.
- **Playing** at 1280x720 by software OpenGL: {span('film', 'shown a second')} pictures a second, by scene.
- **Seen**, against `film`: {all_scenes('1280x720: 16')} dB (sRGB) at 1280x720 on two cores, \
{all_scenes('1920x1080: 128')} at 1920x1080 on sixteen (simulated).
- **In a browser,** unpacking and first picture: {', '.join(loads)}; {least_to_most(shown, 0)} \
pictures a second; {page_seen(16)} dB.
- **Tracing** as exactly as POV-Ray: ten balls (FLIP {flips[0]}) {number(times[0]):.2g} times as fast, 7,381 \
({flips[1]}) {number(times[1]):.2g} times.
- **Radiosity**, {rounded(cell('radiosity', 'triangles', 'columns'))} triangles joined to \
{cell('radiosity', 'polygons', 'columns')}: rays {solved('columns')} rms; hemicubes \
of 16 pixels {solved('columns, hemicubes of 16 pixels')} (thesis {cell('radiosity', 'the thesis, s', 'columns')}); \
vault {rounded(cell('radiosity', 'rms, %', 'vault'))} %.
- **The hall:** 64 lights solved in {rounded(cell('hall', 'processor s, the median of 5', 'all'), 1)} s, relit in \
{rounded(cell('hall', 'all texels', 'noon'), 1)} ms a picture; at noon reflected light \
{rounded(cell('hall', 'reflected light: rms %', 'noon'), 1)} % off path tracing, all \
{rounded(cell('hall', 'all light: rms %', 'noon'), 1)} %.
'''


def filled_in(page, results, make=figures):
    """README.md with the figures between its marks."""
    if len(BLOCK.findall(page)) != 1:
        raise Failed('README.md needs the marks <!-- figures --> and <!-- /figures --> once')
    return BLOCK.sub(lambda _: make(results), page)
