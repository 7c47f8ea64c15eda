"""Measurements of the film: its size, its start, how it plays natively and in browsers, and what a viewer sees."""
import json
import math
import re
import shutil
import statistics
import time
from concurrent.futures import ThreadPoolExecutor

from machine import PROCESSORS, SOURCE
from parts import rows

STATISTICS = '''scene traced between shown missed trace_ms trace_95 between_ms between_95 show_ms show_95 samples
    width'''.split()
PIECE, PAGE_PIECE, SETTLED = 10, 6, 1  # seconds of a played piece, in a browser; until the player has settled


def size(machine):
    names = 'odraz-safe', 'odraz', 'odraz-safe.exe', 'odraz.exe'
    linked, packed, linked_exe, packed_exe = ((machine.build / name).stat().st_size for name in names)
    linux, windows = (json.loads((machine.build / f'{name}.json').read_text()) for name in ('odraz', 'odraz-windows'))
    used = windows['file']
    machine.note('cmake --build build --target film film_windows')
    lines = [('`odraz-safe`: linked and stripped', linked, linked_exe),
             ('`odraz`: packed', packed, used),
             ('of these, headers and stub', linux['overhead'], windows['overhead']),
             ('zeros after them, up to a multiple of 512', '', packed_exe - used),
             ('left of 65536', 65536 - packed, 65536 - used)]
    return [dict(zip(('', 'Linux', 'Windows'), line)) for line in lines]


# --- It starts, and plays ---

def start(machine):
    def look(began):
        machine.run('timeout 60 sh -c "until xdotool search --onlyvisible --name ^odraz$; do sleep 0.01; done"', False)
        return time.monotonic() - began

    def run(program):
        with ThreadPoolExecutor() as threads:
            looking = threads.submit(look, time.monotonic())
            # Start in the film's middle, so that the hall is solved first
            took = machine.timed(f'build/{program} --window --from 100 --to 100.3 --stats')
            seen = looking.result()
        first = float(re.search(r'^first picture after (.*) s$', took.printed, re.M)[1])
        return {'': f'`{program}`', 'seen': f'{seen:.2f}', 'first': f'{first:.2f}', 'mb': f'{took.megabytes:.0f}'}
    with machine.display():
        return [sorted((run(program) for _ in range(3)), key=lambda row: float(row['first']))[1]
                for program in ('odraz', 'odraz-safe')]


def played(printed):
    """The rows that --stats prints, by scene, with `rate`: pictures shown in a second."""
    lines = [line.split() for line in printed.splitlines()]
    scenes = [dict(zip(STATISTICS, line)) for line in lines if len(line) == 13 and line[1].isdigit()]
    for scene in scenes:
        scene['rate'] = f"{60 * int(scene['shown']) / (int(scene['shown']) + int(scene['missed'])):.1f}"
    return scenes


def around_cuts(machine, length=PIECE):
    """The starts of pieces that show all scenes: a piece is played around every other cut between scenes."""
    scenes = rows(machine.run('build/judge_play --machine 16 --summary', noted=False))
    cuts, end = [float(scene['begin']) for scene in scenes[1:]], sum(float(scene['seconds']) for scene in scenes)
    begins = [int(cut - length / 2) for cut in cuts[::2]]
    return begins + ([math.ceil(max(cuts[-1], end - length - 1))] if len(scenes) % 2 else [])


def film(machine):
    with machine.display():
        scenes = [scene for begin in around_cuts(machine) for scene in played(
            machine.run(f'build/odraz-safe --stats --from {begin} --to {begin + PIECE}'))]
    shown, missed, traced = (sum(int(scene[what]) for scene in scenes) for what in ('shown', 'missed', 'traced'))
    seconds = (shown + missed) / 60
    machine.facts.update(piece=PIECE, shown=f'{shown / seconds:.1f}', traced=f'{traced / seconds:.1f}')
    return scenes


# --- What a viewer sees ---

# Pictures are judged at the size that their costs are counted for, over windows of so many seconds in each shot
MACHINES = {'1280x720': ((4, 8, 16, 32, 64, 128), 0.067), '1920x1080': ((16, 128), 0.017), '2560x1440': ((16, 64), 0.017)}


def play_command(screen, machines, length):
    machines = ' '.join(f'--machine {giga}' for giga in machines)
    return f'build/judge_play --screen {screen} --length {length} {machines}'


def cell_of(row):
    return f"{float(row['srgb_db']):.1f} {float(row['flip']):.3f}".replace(' 0.', ' .')


def play(machine):
    """Cells: PSNR, FLIP, and the number of pictures shown in a second of the scene."""
    if not machine.built:
        machine.run('tools/measure/play/costs')  # the simulated players need it
    cells = []
    for screen, (machines, length) in MACHINES.items():
        command = play_command(screen, machines, length)
        rate = {(row['machine'], row['scene']): f" {float(row['a_second']):.0f}"
                for row in rows(machine.run(command + ' --summary', noted=False))}
        for row in rows(machine.run(command)):
            shown = rate.get((row['machine'], row['scene']), '')
            cells.append((f"{screen}: {row['machine']}", row['scene'], cell_of(row) + shown))
    for row in rows(machine.run(play_command('1280x720', [16], 0.067) + ' --judged 320x180')):
        cells.append(('judged at 320x180: 16', row['scene'], cell_of(row)))
    return cells


def seen_plot(machine):
    """Writes play.svg: the PSNR of all scenes against the machine's instructions, a line for each screen."""
    svg = ['<svg xmlns="http://www.w3.org/2000/svg" width="640" height="330" font-family="sans-serif" font-size="13">',
           '<rect width="640" height="330" fill="#fff"/>']

    def at(giga, decibels):
        return 70 + 80 * (math.log2(giga) - 2), 290 - 10 * (decibels - 25)
    for giga in MACHINES['1280x720'][0]:
        svg.append(f'<text x="{at(giga, 25)[0]:.0f}" y="310" text-anchor="middle">{giga} G</text>')
    for decibels in range(25, 55, 5):
        y = at(4, decibels)[1]
        svg.append(f'<path d="M60 {y}H500" stroke="#ccc"/><text x="8" y="{y + 4}">{decibels} dB</text>')
    for screen, colour in zip(MACHINES, ('#06c', '#c30', '#080')):
        points = [at(int(row.split(': ')[1]), float(cell.split()[0])) for row, scene, cell in machine.once(play)
                  if scene == 'all' and row.startswith(screen)]
        svg.append(f'<polyline fill="none" stroke="{colour}" stroke-width="2" points="'
                   + ' '.join(f'{x:.0f},{y:.0f}' for x, y in points) + '"/>')
        x, y = points[-1]
        svg.append(f'<text x="{x + 8:.0f}" y="{y + 4:.0f}" fill="{colour}">{screen}</text>')
    (machine.page.parent / 'play.svg').write_text('\n'.join(svg + ['</svg>', '']))
    return '![PSNR of all scenes against instructions a second, for three screens](play.svg)'


def crops(machine):
    """Makes play.jpg: a part of one picture, on two machines and in `film`."""
    machine.run('build/judge_play --machine 16 --machine 128 --at 20.5 --length 0.017 --crops play.jpg '
                '--corner 420x330')
    shutil.copy(machine.work / 'play.jpg', machine.page.parent)
    return '![a part of one picture, three times](play.jpg)'


def between(machine):
    """Yields rows by scene: the error of draft, play and in-betweens against `film`, and what such pictures cost."""
    kinds = {'play': ('0', 'play'), 'draft': ('0', 'draft'), **{f'b{gap}': (gap, 'play') for gap in '246'}}
    levels = {'1': 'play', '2': 'draft'}
    counted = [row for row in rows((SOURCE / 'tools/measure/play/costs.csv').read_text()) if row['width'] == '1280']
    costs = {(float(row['seconds']), row['gap'], levels[row['level']]): float(row['serial']) + float(row['parallel'])
             for row in counted}
    moments = machine.run('build/probe --list', noted=False).split()[1::3]
    found = rows(machine.run('build/probe --errors --setting play --setting draft --gap 0 --gap 2 --gap 4 '
                             '--gap 6 ' + ' '.join(f'--at {at}' for at in moments)))
    for scene in dict.fromkeys(row['scene'] for row in found):
        line = {'scene': scene}
        for name, kind in kinds.items():
            of = [row for row in found if (row['scene'], row['gap'], row['level']) == (scene, *kind)]
            error = statistics.mean(10 ** (-float(row['srgb_db']) / 10) for row in of)
            line[name] = f'{-10 * math.log10(error):.1f}'
            line['m_' + name] = f"{statistics.mean(costs[(float(row['seconds']), *kind)] for row in of) / 1e3:.0f}"
        yield line


def played_and_simulated(machine):
    """Yields rows that compare the film as played here with a simulated machine, which executes as many instructions in
    each second as this one did. So other work on this machine slows both."""
    def figures(row):
        fewer = (1 - float(row['width']) / 1280) / 0.35  # steps beyond `draft`, as the governor counts them
        return float(row['a_second']), float(row['traced']) / float(row['seconds']), float(row['level']) + fewer
    with machine.display():
        for begin in around_cuts(machine):
            machine.run(f'build/odraz-debug --shown shown.csv --mute --from {begin} --to {begin + PIECE}')
            printed = rows(machine.run(f'build/judge_play shown.csv --simulate --cores {PROCESSORS} '
                                       f'--since {begin + SETTLED} --summary'))
            for scene in dict.fromkeys(row['scene'] for row in printed):
                real, model = (row for row in printed if row['scene'] == scene)
                line = {'scene': scene, 'giga': f"{float(real['giga']):.1f}"}
                for name, a, b in zip(('shown', 'traced', 'level'), figures(real), figures(model)):
                    change, digits = (b - a, 2) if name == 'level' else (b / a - 1, 1)
                    line |= {name: f'{a:.{digits}f}', 'model_' + name: f'{b:.{digits}f}',
                             'change_' + name: f'{change * 100:+.0f}'}
                yield line


# --- In a browser ---

BROWSERS = 'chromium', 'firefox', 'webkit'
MOMENTS = 14, 24, 38, 58, 158  # outside the hall, since native times would include solving it


def page_size(machine):
    """Rows of the page's sizes, which its build prints."""
    (machine.build / 'odraz.html').unlink(missing_ok=True)
    printed = machine.run(['cmake', '--build', machine.build, '--target', 'film_web'], noted=False)
    numbers = [int(word) for word in re.findall(r'\d+', re.search(r'html: (.*)', printed)[1])]
    whole, coded, scripts, program, decoder, loader = numbers[:6]
    return [{'': name, 'bytes': value} for name, value in (
        ('`odraz.html`', whole), (f'... scripts of {scripts} and program of {program} coded', coded),
        ('... the decoder deflated', decoder), ('... its loader and the first line of markup', loader),
        ('... escapes of bytes that HTML would change', whole - coded - decoder - loader))]


def native_ms(machine, second):
    """Processor time of a picture: the difference of two dumps of that second at 15 and 30 pictures a second."""
    low, high = (machine.timed(f'build/odraz-safe --dump dumped --fps {fps} --from {second + 1} --to {second + 2} '
                               '--size 1280x720 --quality draft', noted=False).processor for fps in (15, 30))
    return (high - low) / 15 * 1e3


def page_times(machine):
    browsers = {}
    with machine.display('1280x800'):
        for name in BROWSERS:
            command = f"node tools/measure/bench/page.mjs times {name} build/odraz.html {' '.join(map(str, MOMENTS))}"
            browsers[name] = {row['second']: float(row['ms']) for row in rows(machine.run(command))}
    lines = []
    for moment in MOMENTS:
        native, *each = native_ms(machine, moment), *(browsers[name][str(moment)] for name in BROWSERS)
        lines.append({'second': moment, 'native': f'{native:.1f}'})
        for name, ms in zip(BROWSERS, each):
            lines[-1] |= {name: f'{ms:.1f}', 'times_' + name: f'{ms / native:.2f}'}
    ratio = statistics.geometric_mean(float(line['times_chromium']) for line in lines)
    machine.facts['ratio'] = f'{ratio:.2f}'
    return lines


def page_play(machine):
    """Yields rows about the start; keeps the rows of the scenes for page_scenes()."""
    machine.facts['piece'], machine.played = PAGE_PIECE, {}
    starts = ' '.join(map(str, around_cuts(machine, PAGE_PIECE)))
    with machine.display('1280x800'):
        for name in BROWSERS:
            printed = machine.run(
                f'node tools/measure/bench/page.mjs play {name} build/odraz.html {PAGE_PIECE} {starts}')
            machine.played[name] = played(printed)
            lines = re.findall(r'^page,(.*)$', printed, re.M)
            columns = list(zip(*([float(cell) for cell in line.split(',')] for line in lines)))
            opens, first, before = map(statistics.median, columns[:3])
            yield {'browser': name, 'opens': f'{opens:.1f}', 'first': f'{first:.2f}', 'before': f'{before:.0f}',
                   'most': f'{max(columns[3]):.0f}'}


def page_scenes(machine):
    for name in BROWSERS:
        for scene in machine.played[name]:
            for key, title in (('rate', 'shown a second'), ('width', 'pixels traced across'),
                               ('trace_ms', 'ms to trace: median'), ('trace_95', '95 %')):
                yield scene['scene'], f'{name}: {title}', scene[key]


def page_seen(machine):
    command = play_command('1280x720', (8, 16, 32, 64), 0.05)
    for row in rows(machine.run(f"{command} --page {machine.facts['ratio']}")):
        yield row['machine'], row['scene'], cell_of(row)
