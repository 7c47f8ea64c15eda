"""The radiosity program: models that it solves, and the light of their elements. Among the options of these functions
a text such as '--rays 64 --element 0.25' stands for its words."""
import functools
import itertools
import math
import re
import signal
from pathlib import Path

from pictures import numpy
from running import BUILD, SOURCE, needs_built, run

needs_built('radiosity')
RADIOSITY = BUILD / 'radiosity'
OPEN_ROOM = SOURCE / 'tests/support/models/open_room.obj'


def split(words):
    """The words of a command, where a text of options stands for its words."""
    return itertools.chain(*[word.split() if str(word).startswith('--') else [word] for word in words])


def radiosity(*words, **options):
    """running.run for the program: radiosity('export', 'cube.rad', '--csv cube.csv').stdout"""
    return run(RADIOSITY, *split(words), **options)


def generate(kind, path, *options):
    """Writes an example model, and returns its path."""
    assert re.search(r': \d+ (polygons|triangles)$', radiosity('generate', kind, '-o', path, *options).stdout, re.M)
    return path


def elements_of(path):
    """A table of elements (export --csv) as an array with the attributes polygon, x, y, z, nx, ny, nz, area, r, g, b,
    material. It has a row, and its numbers are finite. elements[elements.ny == 1] are those that face up."""
    with open(path) as file:
        names = file.readline().strip().split(',')
        kinds = [(name, 'U40' if name == 'material' else float) for name in names]
        elements = numpy.loadtxt(file, kinds, delimiter=',', comments=None, ndmin=1).view(numpy.recarray)
    assert elements.size and all(numpy.isfinite(elements[name]).all() for name in names if name != 'material')
    return elements


def mean_light(elements):
    """The mean light of elements by their areas: red, green and blue."""
    return numpy.average([elements.r, elements.g, elements.b], axis=1, weights=elements.area)


class Solution:
    """A solved model: the file's path, and what solve printed, output on stdout and errors on stderr."""

    def __init__(self, path, output, errors):
        self.path, self.output, self.errors = path, output, errors

    def export(self, *options):
        """Returns what export prints."""
        return radiosity('export', self.path, *options).stdout

    def render(self, picture, *options):
        """Returns what render prints: its camera."""
        return radiosity('render', self.path, '-o', picture, *options).stdout

    @functools.cached_property
    def elements(self):
        """Its elements (elements_of), from NAME.csv beside NAME.rad."""
        csv = self.path.with_suffix('.csv')
        self.export('--csv', csv)
        return elements_of(csv)


def solve(model, *options, text=None, to=None):
    """Solves a model, and returns its Solution. text: what to write into the model first. The solution is NAME.rad
    beside NAME.obj, or to."""
    if text:
        Path(model).write_text(text)
    path = Path(to or Path(model).with_suffix('.rad'))
    result = radiosity('solve', model, *options, '-o', path)
    assert '\nprocessor seconds' in result.stdout
    return Solution(path, result.stdout, result.stderr)


def interrupted_at(pattern, program, outputs):
    """Sends Ctrl-C to a running.Program when a line of outputs(), such as program.errors, begins with the pattern.
    Returns its exit status. The test fails if the program ends before such a line comes."""
    program.comes(lambda: re.search(f'^{pattern}', outputs(), re.M))
    program.signal(signal.SIGINT)
    return program.ended()


def square(material, half, x=0, y=0, z=0, faces='up'):
    """OBJ text of a horizontal square around a point, with half the length of its sides."""
    corners = [(x - half, z - half), (x - half, z + half), (x + half, z + half), (x + half, z - half)]
    points = ''.join(f'v {x:.6f} {y:.6f} {z:.6f}\n' for x, z in corners)
    return f'{points}usemtl {material}\nf {"-4 -3 -2 -1" if faces == "up" else "-1 -2 -3 -4"}\n'


def room(floor, walls, ceiling, low=(0, 0, 0), high=(1, 1, 1)):
    """OBJ text of a box between two corners, whose surfaces face inwards. It has no ceiling if that has no material."""
    points = ''.join('v {:.6f} {:.6f} {:.6f}\n'.format(*corner) for corner in itertools.product(*zip(low, high)))
    top = ceiling and f'usemtl {ceiling}\nf -6 -2 -1 -5\n'
    return (f'{points}usemtl {floor}\nf -8 -7 -3 -4\n{top}'
            f'usemtl {walls}\nf -8 -4 -2 -6\nf -7 -5 -1 -3\nf -8 -6 -5 -7\nf -4 -3 -1 -2\n')


def hills(width, height, up='y'):
    """OBJ text of hills and valleys: 800 triangles on a square around the origin."""
    n = 20
    points = ''
    for j, i in itertools.product(range(n + 1), repeat=2):
        x, z, high = (i / n - 0.5) * width, (j / n - 0.5) * width, height * math.sin(i / 3) * math.cos(j / 3)
        points += f'v {x:.6f} {high:.6f} {z:.6f}\n' if up == 'y' else f'v {x:.6f} {-z:.6f} {high:.6f}\n'
    corners = [j * (n + 1) + i + 1 for j, i in itertools.product(range(n), repeat=2)]
    return points + ''.join(f'f {a} {a + n + 1} {a + 1}\nf {a + 1} {a + n + 1} {a + n + 2}\n' for a in corners)
