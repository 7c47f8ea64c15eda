"""Measurements of the tracer: its qualities, their knobs, the parts of a picture; and the comparison with POV-Ray."""
import math
import re

import counting
from machine import at_once
from parts import markdown, rows

SCENES = 'A', 'table', 'flake', 'hall', 'credits'
SETTINGS = 'draft', 'play', 'film', 'play,grid=1'
SMALL = '320x180'  # size at which instructions are counted
# The names of settings in tables
TITLES = {'play,grid=1': 'one sample a pixel', 'play,grid=2': 'four samples a pixel',
          'play,smallest=4,again=0.12': 'twelve samples inside pixels',
          **{f'level={level}': f'{"film" if level < 1 else "play"} to '
          f'{"play" if level < 1 else "draft"}, {level % 1:g}' for level in (0.25, 0.5, 0.75, 1.25, 1.5, 1.75)}}
KNOBS = [*SETTINGS, 'play,grid=2', *(name for name in TITLES if name[:5] == 'level'), *(
    f'play,{knob}={value}' for knob, values in (
        ('smallest', ('4,again=0.12',)), ('coarse', (4, 8, 32)), ('threshold', (0.01, 0.02, 0.08)),
        ('markThreshold', (0, 0.1)),
        ('edge', (0.03, 0.12, 0.2, 0.4)), ('outline', (0.06,)), ('markWeight', (0.1,)), ('depth', (2, 3)),
        ('cutoff', (0.1, 0.00625)))
    for value in values)]


def title(setting):
    return TITLES.get(setting, setting.replace('play,', '').replace('=', ' '))


def measured(machine, scenes, settings, width=1280):
    command = ['build/tradeoff', '--width', width]
    command += [word for scene in scenes for word in ('--scene', scene)]
    command += [word for setting in settings for word in ('--setting', setting)]
    # The CSV has blanks in place of the commas of a setting
    return [{**row, 'setting': row['setting'].replace(' ', ',')} for row in rows(machine.run(command))]


def millions(count):
    return f'{count / 1e6:.2f}' if count < 10e6 else f'{count / 1e6:.0f}'


def parts_of_pictures(machine):
    """Yields instructions by setting or part and by scene."""
    machine.note(f'tools/measure/bench/instructions --parts --size {SMALL} ' + ' '.join(
        f'--setting {setting}' for setting in SETTINGS))
    counts = counting.pictures(machine, SCENES, SETTINGS, SMALL, ('posing', 'glare', 'development'))
    return ((title(setting), scene, millions(count)) for scene, setting, count in counts)


def qualities(machine):
    """A table for each quantity."""
    found = measured(machine, SCENES, SETTINGS)

    def by_scene(head, value):
        cells = {(row['setting'], row['scene']): row[value] for row in found}
        return markdown([[head, *SCENES]] + [
            [title(setting), *(cells[setting, scene] for scene in SCENES)] for setting in SETTINGS])
    return '\n\n'.join(by_scene(*each) for each in (
        ('ms', 'cpu_ms'), ('mean FLIP', 'mean_flip'), ('linear dB', 'linear_psnr_db'), ('sRGB dB', 'srgb_psnr_db'),
        ('samples a pixel', 'samples_per_pixel')))


def knobs(machine):
    counted = {setting: count for scene, setting, count in counting.pictures(machine, ['A'], KNOBS, SMALL)}
    for row in measured(machine, ['A'], KNOBS):
        yield {**row, 'setting': title(row['setting']), 'instructions': millions(counted[row['setting']])}


# --- POV-Ray ---

PEER = {'A': 640, 'B': 320}  # widths of the pictures; B has edges in every pixel, which takes time
PEER_OPTIONS = '-A', '+AM2 +A0.1 +R3', '+AM2 +A0.3 +R3'
QUALITIES = 'draft', 'play', 'film', 'reference'  # odraz's front, of growing time
PEER_SETTINGS = 'play,grid=1', *QUALITIES


def povray(options, scene, picture, width):
    return f'povray +I{scene}.pov +O{picture} -D -GA +FN +W{width} +H{width * 9 // 16} {options}'


def povray_rows(machine, scene):
    """Yields rows of POV-Ray's pictures. The reference has 144 samples a pixel: the linear mean of a picture of four
    times the width and height with nine samples in every pixel."""
    width, small = PEER[scene], PEER[scene] // 4
    all_samples = '+AM1 +A0.0 +R3 -J File_Gamma=1.0 Bits_Per_Color=16'
    machine.run(povray(all_samples, scene, 'large.png', width * 4), noted=False)
    machine.run('build/compare --linear large.png reference.png --by 4', noted=False)
    counted = at_once(lambda options: counting.spent(
        machine, povray(options + ' +WT1', scene, f'small{options[5:9]}.png', small)), PEER_OPTIONS)
    for options, count in zip(PEER_OPTIONS, counted):
        took = machine.timed(povray(options, scene, 'picture.png', width))
        compared = machine.run('build/compare picture.png reference.png --seen --max 255', noted=False)
        flip, linear, shown = re.findall(r'[0-9.]+', re.search(r'^mean flip.*', compared, re.M)[0])[:3]
        yield {'setting': f'POV-Ray {options}', 'ms': f'{took.processor * 1e3:.0f}', 'mean_flip': flip,
               'linear_psnr_db': linear, 'srgb_psnr_db': shown, 'count': millions(count)}


def our_rows(machine, scene):
    small = f'{PEER[scene] // 4}x{PEER[scene] * 9 // 64}'
    counted = {setting: count for _, setting, count in counting.pictures(machine, [scene], PEER_SETTINGS, small)}
    for row in measured(machine, [scene], PEER_SETTINGS, PEER[scene]):
        yield {**row, 'setting': 'odraz ' + title(row['setting']), 'ms': row['cpu_ms'],
               'count': millions(counted[row['setting']])}


def time_at(flip, front):
    """The time at which pictures of that error are traced: interpolated, in logarithms, between two settings of the
    front (pairs of error and time); None if no two settings enclose it."""
    front = sorted(front)
    for (low, slow), (high, fast) in zip(front, front[1:]):
        if low <= flip <= high:
            return slow * (fast / slow) ** (math.log(flip / low) / math.log(high / low))
    return None


def against_povray(scene):
    def part(machine):
        (machine.work / f'{scene}.pov').write_text(machine.run(f'build/trace_once pov {scene}', noted=False))
        lines = [*povray_rows(machine, scene), *our_rows(machine, scene)]
        front = [(float(line['mean_flip']), float(line['ms'])) for line in lines if line['setting'][6:] in QUALITIES]
        for line in lines:
            equal = time_at(float(line['mean_flip']), front)
            line['times'] = f"{float(line['ms']) / equal:.1f}" if equal else ''
        width, keys = PEER[scene], ('setting', 'ms', 'mean_flip', 'linear_psnr_db', 'srgb_psnr_db', 'times', 'count')
        return markdown([[f'{scene}; {width}x{width * 9 // 16}', 'processor ms', 'mean FLIP', 'linear dB', 'sRGB dB',
                          'times at equal FLIP', f'M instructions; {width // 4}x{width * 9 // 64}']] + [
            [line[key] for key in keys] for line in lines])
    return part
