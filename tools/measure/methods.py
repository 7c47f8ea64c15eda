"""Measurements of the packer, of radiosity and of transfer; and the figures that tests record."""
import json
import random
import re
import shutil
import statistics
from functools import lru_cache
from pathlib import Path

import counting
import sources
from machine import Failed, at_once
from parts import markdown, rows

# --- Packing ---

LIBRARIES = '/usr/lib/x86_64-linux-gnu/'
# Parts of the instructions of this film and of system libraries: name, file, offset and size in KB
CODE = (('odraz', 'build/odraz-safe', 16, 16), ('odraz', 'build/odraz-safe', 32, 48),
        ('libm', LIBRARIES + 'libm.so.6', 128, 16), ('libm', LIBRARIES + 'libm.so.6', 32, 48),
        ('libstdc++', LIBRARIES + 'libstdc++.so.6', 64, 48), ('libstdc++', LIBRARIES + 'libstdc++.so.6', 128, 128),
        ('llvmpipe', LIBRARIES + 'dri/swrast_dri.so', 3072, 48),
        ('llvmpipe', LIBRARIES + 'dri/swrast_dri.so', 2048, 128),
        ('llvmpipe', LIBRARIES + 'dri/swrast_dri.so', 1024, 256))
PEERS = {'xz -9e --x86': 'xz --x86 --lzma2=preset=9e -k -c "$1"', 'zstd --ultra -22': 'zstd --ultra -22 -q -c "$1"',
         'brotli -q 11': 'brotli -q 11 -w 24 -c "$1"',
         'zpaq -m5': 'zpaq a "$1.zpaq" "$1" -m5 >/dev/null 2>&1; cat "$1.zpaq"'}
PROGRAMS = '/usr/bin/bash', '/usr/bin/curl'
# Fewer contexts, each with a short search; less and more memory; searches that start from arbitrary contexts
MODELS = {
    **{f'{n} contexts': f'--contexts {n} --search 3' for n in (4, 8, 12)}, '**16 contexts (ships)**': '',
    **{f'2^{n} slots': f'--slots {n}' for n in (16, 18, 20, 23)},
    '0 s of search': '--arbitrary', '10 s of search': '--arbitrary --search 10'}


@lru_cache(None)
def instructions(path):
    """The instructions of a program; empty if there is no such program."""
    return sources.contents(Path(path), '-j', '.text') if Path(path).exists() else b''


def samples(machine):
    """Files of instructions, by name."""
    found = {}
    for name, file, begin, kilobytes in CODE:
        code = instructions(machine.words([file])[0])[begin * 1024:(begin + kilobytes) * 1024]
        if len(code) == kilobytes * 1024:
            found[f'{name} {kilobytes}K'] = machine.work / f'{name}-{kilobytes}'
            found[f'{name} {kilobytes}K'].write_bytes(code)
    return {**found, 'the whole film': machine.words(['build/odraz-safe'])[0]}


def packers(machine):
    files = machine.once(samples)
    peers = {name: command for name, command in PEERS.items() if shutil.which(name.split()[0])}
    ours = [rows(machine.run(['build/bench_pack', file], noted=False))[0] for file in files.values()]
    machine.note('build/bench_pack build/odraz-safe')

    def by_peers(file):
        return {name: int(machine.run(['sh', '-c', f'{{ {command}; }} | wc -c', 'sh', file], noted=False))
                for name, command in peers.items()}
    sizes = at_once(by_peers, files.values())
    own = rows(machine.run('build/bench_pack --model intro/odraz.model build/odraz-safe'))
    lines = [*zip(files, ours, sizes), ('... with its own contexts', own[0], sizes[-1])]

    def share(row, others, peer):
        return f"{int(row['payload']) / others[peer]:.2f}" if peer in others else ''
    return markdown([['code', 'bytes', *peers, "odraz's pack", 'to xz', 'to zpaq', 'encode s', 'decode KB/s']] + [
        [name, row['bytes'], *others.values(), row['payload'], share(row, others, 'xz -9e --x86'),
         share(row, others, 'zpaq -m5'), row['encode_s'], row['decode_kb_s']] for name, row, others in lines])


def pack_instructions(machine):
    sample = machine.once(samples)['odraz 16K']
    encode, decode = at_once(lambda of: counting.spent(machine, ['build/bench_pack', sample], of),
                             ('*pack::encode<*', 'pack::decodeWithStub*'))
    return f'Millions of instructions for "odraz 16K": {encode / 1e6:.0f} to encode, {decode / 1e6:.0f} to decode.'


def programs(machine):
    """Yields rows of whole programs: sizes, and the seconds in which the packed ones start."""
    for program in PROGRAMS:
        xz = int(machine.run(['sh', '-c', f"{PEERS['xz -9e --x86']} | wc -c", 'sh', program], noted=False))
        row = {'program': Path(program).name, 'file': Path(program).stat().st_size, 'xz': xz}
        for prefix, options in (('', []), ('fast_', ['--fast'])):
            machine.run(['build/pack', program, '-o', 'packed', *options])
            size = (machine.work / 'packed').stat().st_size
            row |= {prefix[:-1] or 'packed': size, (prefix or 'to_') + 'xz': f'{size / xz:.2f}',
                    prefix + 'start': f"{machine.timed(['./packed', '--version'], noted=False).processor:.1f}"}
        yield row


def models(machine):
    for name, options in MODELS.items():
        packed = machine.run(f'build/bench_pack --model intro/odraz.model {options} build/odraz-safe')
        yield {'': name, **rows(packed)[0]}


# --- Radiosity and transfer ---

# Models of the sizes in table 4.1 of the thesis, then three models with few triangles in one plane: kind, a triangle's
# largest area, options (at least as many elements as triangles), seconds of the thesis at 100 x 100 pixels, and
# whether it is compared with path tracing
SOLVED = (('columns', 0.19531, '--element 0.1636', 280, True),
          *(('columns', 0.19531, f'--element 0.1636 --hemicube {pixels}', 280, True) for pixels in (16, 32, 100)),
          ('columns', 0.035785, '--element 0.0316', 3500, False),
          ('columns', 0.0088765, '--element 0.0079', 34980, False), ('cave', 0.046735, '', '', False),
          ('vault', 0.0552, '', '', True), ('terrain', 0.018266, '', '', True))


def solutions(machine):
    """Yields the whole solutions. Those that are compared with path tracing are made three times."""
    machine.note('build/radiosity solve columns.obj -o columns.rad --element 0.1636')
    machine.note('build/radiosity_errors columns.obj columns.rad --side 64')
    for kind, area, options, thesis, compared in SOLVED:
        machine.run(f'build/radiosity generate {kind} -o {kind}.obj --area {area}', noted=False)
        found = [machine.run(f'build/radiosity solve {kind}.obj -o {kind}.rad {options}', noted=False)
                 for _ in range(3 if compared else 1)]
        seconds = statistics.median(sum(map(float, re.findall(
            r'[0-9]+\.[0-9]+', re.search('^processor seconds: .*', one, re.M)[0]))) for one in found)
        row = {what: count for count, what in re.findall(r'(\d+) (triangle|polygon|element|site|patch|ray)', found[0])}
        pixels = options.partition('--hemicube ')[2]
        by = f', hemicubes of {pixels} pixels' if pixels else ''
        errors = ['', '']
        if compared:
            printed = machine.run(f'build/radiosity_errors {kind}.obj {kind}.rad --side 64', noted=False)
            errors = re.search(r'median ([0-9.]+) .* rms ([0-9.]+) ', printed).groups()
        yield {'ray': '', **row, 'model': kind + by, 'sites': row.get('site') or row['patch'], 'thesis': thesis,
               'seconds': f'{seconds:.2f}', 'median': errors[0], 'rms': errors[1],
               'each': f"{seconds * 1e6 / int(row['triangle']):.2f}"}


def columns(machine):
    """The hall of columns as it is generated."""
    machine.run('build/radiosity generate columns -o columns.obj', noted=False)
    solve = 'build/radiosity solve columns.obj -o columns.rad --rays 16'
    machine.note(solve)
    return ('The hall of columns as it is generated, with 16 rays from every element: '
            f'{counting.spent(machine, solve) / 1e6:.0f} million instructions.')


def hall(machine):
    """The errors of the film's hall against path tracing, their causes, and other settings, with a plot."""
    printed = machine.run('build/hall_light --causes --trade hall.svg').strip()
    shutil.copy(machine.work / 'hall.svg', machine.page.parent)
    return printed + '\n\n![errors of the hall against seconds](hall.svg)'


def posing(machine):
    count = counting.counted(machine, counting.posed(machine, 'hall', '320x180'), 'posing')
    return f'Posing a picture of the hall, with all of its light: {count / 1e6:.1f} million instructions.'


def texels(printed):
    return re.search(r'; (\d+ texels),', printed)[1]


def vault(machine):
    """The output of --check for the vault, by bands."""
    machine.run('build/radiosity generate vault -o vault.obj', noted=False)
    return {bands: machine.run(f'build/radiosity transfer vault.obj -o vault.prt --bands {bands} --rays 64 --check')
            for bands in (1, 3, 5)}


def environments(machine):
    """Yields the errors of rows and of clusters."""
    checks = machine.once(vault)
    machine.facts['vault'] = texels(checks[5])
    for bands, printed in checks.items():
        block = printed[printed.index('error against'):].split('\nerror %')[0]
        for line in block.splitlines()[1:]:
            name, values = line[4:24].strip(), line[24:].split()
            if values and re.match(r'[0-9.]+$', values[0]):
                yield name, bands, f'{values[0]} / {values[1]}'


def subspaces(machine):
    printed = machine.once(vault)[5]
    lines = [line.split() for line in printed[printed.index('CPCA'):].splitlines()]
    head = ['MB', 'axes', 'of the rows %', 'of the light %', 'axes of one', 'of the rows %', 'of the light %']
    return markdown([head, *(line for line in lines if len(line) == 7 and re.match(r'[0-9.]+$', line[0]))])


def sky(path):
    """Writes a picture of the sky that lights every band in every colour, since a band without light costs nothing."""
    random.seed(1)
    pixels = (random.randbytes(3) + bytes([128 if i % 97 else 133]) for i in range(1, 32 * 64 + 1))
    path.write_bytes(b'#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n' + b''.join(pixels))


def turning(machine):
    """Yields the speed of the hall of columns, as rows and as clusters, while the sky turns."""
    machine.run('build/radiosity generate columns -o columns.obj', noted=False)
    lamps = ' '.join(f'--lamp {x},6,0,1,9,8,6' for x in (-10, 0, 10))
    machine.facts['columns'] = texels(machine.run(
        f'build/radiosity transfer columns.obj -o columns.prt --element 0.46 --rays 64 --glossy floor {lamps}'))
    sky(machine.work / 'sky.hdr')
    seconds = 5
    with machine.display('900x700'):
        for light, options in (('rows', ''), ('clusters', ' --rank 16')):
            took = machine.timed(
                f'build/radiosity view columns.prt --sky sky.hdr --size 640x360 --spin {seconds}{options}')
            rate = float(re.search(r'([0-9.]+) pictures a second', took.printed)[1])
            yield {'light': light, 'rate': f'{rate:.1f}', 'ms': f'{took.processor * 1e3 / (rate * seconds):.1f}'}


# --- Proofs ---

PROOFS = {  # tests whose figures are shown, by program. They record them with tests/support/figure.h
    'maths_exhaustive_test': [f'Exhaustive.{name}' for name in ('sin', 'cos', 'acos', 'exp2', 'log2', 'pow')],
    'radiosity_tests': ['FormFactor.CoaxialDiscs', 'FormFactor.OfUnitSquaresFallsWithResolution',
                        'Solve.EnergyIsConserved'],
    'show_tests': ['Hall.BouncesConvergeToTheSolution', 'TracedHall.EveryPixelShowsWhatARayInDoublePrecisionHits',
                   'Motion.TheClimaxMovesMost'],
    'sound_tests': ['Note.IsInTuneOverEightOctaves', 'Note.DoesNotAlias', 'Note.BendsWithoutAliasing',
                    'Noise.MatchesTheFiltersClosedForm'],
    'trace_tests': ['Extremes.BallsAreHitOrMissedAsInDouble', 'Extremes.SixtyFourBouncesStayTrue',
                    'Adaptive.EachPixelShowsTheShapeInItsMiddle', 'AdaptiveFaults.DoesNotFlicker'],
    'transfer_tests': ['SphericalHarmonics.AgreeWithTheRecurrence', 'Day.IsWithinAFewPerCentOfExactSolutions',
                       'Gloss.AgreesWithRays']}


def recorded(report, wanted):
    """Yields what tests recorded, from GoogleTest's report. Each wanted test must have recorded something."""
    found = {f"{one['classname']}.{one['name']}": one for suite in report['testsuites'] for one in suite['testsuite']}
    for name in wanted:
        figures = {what: value.split(' <= ') for what, value in found.get(name, {}).items() if ' <= ' in str(value)}
        if not figures:
            raise Failed(f'{name} recorded no figure: see tests/support/figure.h')
        for what, (figure, limit) in figures.items():
            yield {'test': name, 'what': what, 'figure': f'{float(figure):.3g}', 'limit': f'{float(limit):.3g}'}


def proofs(machine):
    for program, wanted in PROOFS.items():
        machine.run(['env', 'ODRAZ_EVERY=251', f'build/tests/{program}', '--gtest_output=json:tests.json',
                     f"--gtest_filter={':'.join(wanted)}"])
        yield from recorded(json.loads((machine.work / 'tests.json').read_text()), wanted)
