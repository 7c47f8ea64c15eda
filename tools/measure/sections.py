"""The sections of RESULTS.md: their sources, programs, commands, columns and texts."""
from dataclasses import dataclass, field

import film
import methods
import tracer
from parts import matrix, table

RADIOSITY = 'libcli11-dev nlohmann-json3-dev libstb-dev libtinyexr-dev zlib1g-dev'.split()
PICTURES = 'libcli11-dev libstb-dev libtinyexr-dev zlib1g-dev'.split()


@dataclass
class Section:
    name: str
    title: str
    minutes: float  # on two quiet cores
    sources: list  # files and folders; if one changes, the section is stale ...
    programs: list  # ... unless these files in build/ are the same
    parts: list  # paragraphs, and functions that measure
    packages: list = field(default_factory=list)
    targets: list = field(default_factory=list)  # to build, as well as the programs


SECTIONS = [
    Section(
        'size', 'Size', 0.1,
        sources=['intro', 'packer', 'CMakeLists.txt'], programs=['odraz-safe', 'odraz-windows.elf', 'pack_film'],
        targets=['film', 'film_windows'],
        parts=[
            table(film.size, '; Linux; Windows'),
            '''The size of the packed film varies by a few bytes with its commit's name. `tools/ledger rooms` prints the
            size of each part. For Windows, zeros fill the file; all figures but theirs are of the bytes used.''']),
    Section(
        'start', 'Start-up', 0.3,
        sources=['intro', 'packer'], programs=['odraz-safe', 'pack_film'], targets=['film'],
        packages=['xvfb', 'xdotool'],
        parts=[
            table(film.start, '; seen = seconds until its window is seen; first = until the first picture; '
                  'mb = MB resident at most'),
            '''The run with the median time until its first picture, with the hall solved. The clock starts when the
            first instruction of the program runs. The packed film decodes itself while the bar grows, and frees the
            decoder's memory before the first picture.''']),
    Section(
        'film', 'The film, played', 0.8,
        sources=['intro'], programs=['odraz-safe', 'judge_play'], packages=['xvfb'],
        parts=[
            table(film.film, '''scene; rate = shown a second; traced = pictures traced; between = in-betweens made;
                shown; missed = sixtieths of a second without a new picture; trace_ms = ms to trace: median;
                trace_95 = 95 %; between_ms = ms to make an in-between: median; between_95 = 95 %;
                show_ms = ms to show: median; show_95 = 95 %; samples = samples a traced pixel;
                width = pixels traced across'''),
            'Over all scenes: {shown} pictures a second were shown, {traced} traced.',
            '''{piece} seconds around every other cut between scenes were played at 1280x720, on a display in memory
            with software OpenGL, which runs on the same cores. The governor is on. Times are by the clock.''']),
    Section(
        'play', 'What a viewer sees, by machine and screen', 8.1,
        sources=['intro/play', 'intro/timeline', 'intro/trace', 'intro/show', 'tools/measure/play',
                 'tools/measure/play/costs.csv'],
        programs=['judge_play', 'odraz-debug'], packages=[*PICTURES, 'xvfb', 'libglfw3-dev'],
        parts=[
            film.seen_plot,
            matrix(lambda machine: machine.once(film.play), 'screen: G instructions'),
            '''The film's own player and governor, simulated on machines of G times 10^9 instructions a second, with 7 G
            a core: two cores have about 16, a laptop of 2020 about 60. The costs of pictures are counted
            (`play/costs.csv`), for in-betweens by their gap. A cell has the PSNR in sRGB (dB), FLIP, and the number of
            pictures shown in a second of the scene. At each sixtieth of a second the picture on the screen is compared
            with the same moment in `film` quality, at the size of the screen: for four sixtieths in the middle of
            each shot at 1280x720, for one on larger screens. FLIP is of every fifth of these pictures. The
            last row was judged at 320x180, with all pictures shrunk alike, as in earlier versions: there outlines are
            four times as large a part of the picture.''',
            film.crops,
            'Of one picture at 1280x720: as two cores show it, as sixteen do (both simulated), and in `film`.',
            'This machine, played and simulated:',
            table(film.played_and_simulated, '''scene; giga = G instructions; shown = shown a second: played;
                model_shown = simulated; change_shown = change (%); traced = traced a second: played;
                model_traced = simulated; change_traced = change (%); level = level: played;
                model_level = simulated; change_level = change (% of a step)'''),
            '''Pictures shown and traced in a second of the scene, at 1280x720, on a display in memory, whose software
            OpenGL runs on the same cores. Pieces around every other cut, as above, without their first second, in which
            new memory slows the first pictures. The level is 0 for `film`, 1 for `play`, 2 for `draft`; beyond it, each
            step gives up 35 % of the width. The simulated machine is as fast in each second as this one was.''']),
    Section(
        'between', 'In-betweens against traced pictures', 0.4,
        sources=['intro/trace', 'intro/show', 'tools/measure/play/costs.csv'], programs=['probe'],
        parts=[
            table(film.between, '''scene; play = play, dB; draft = draft; b2 = in-between at a gap of 2; b4 = 4; b6 = 6;
                m_play = M instructions: play; m_draft = draft; m_b2 = in-between at a gap of 2; m_b4 = 4; m_b6 = 6'''),
            '''PSNR in sRGB against `film` at 1280x720, and the instructions of such pictures (`play/costs.csv`): the
            means over moments six seconds apart. In-betweens are half-way between two pictures of `play`, whose gap is
            in sixtieths of a second. "What a viewer sees" has in-betweens at the gaps that the player chooses.''']),
    Section(
        'page', 'The film as a page', 4.4,
        sources=['intro', 'packer/model', 'packer/web', 'tests/programs/web/browser.mjs',
                 'tools/measure/bench/page.mjs', 'tools/measure/play/costs.csv'],
        programs=['odraz.html', 'odraz-safe', 'judge_play'], targets=['film_web'],
        packages=['nodejs', 'chromium', 'firefox-esr', 'webkit2gtk-driver', 'libwebkit2gtk-4.1-0', 'xvfb'],
        parts=[
            table(film.page_size, '; bytes'),
            'Scripts and program are coded by the packer\'s model, with a parser of WebAssembly.',
            table(film.page_times, '''second = from (s); native = native: ms a picture; chromium = Chromium;
                firefox = Firefox; webkit = WebKit; times_chromium = Chromium to native;
                times_firefox = Firefox to native; times_webkit = WebKit to native'''),
            '''Pictures of 1280x720 in `draft`, during one second of the film, on one thread. For the native film it is
            the processor time; for the page it is the median time by the clock of a worker, after the browser has
            optimised the program. The geometric mean of Chromium to native is {ratio}.''',
            table(film.page_play, '''browser; opens = s until the page is there; first = s from the click to the first
                picture; before = MB before the click; most = MB at most'''),
            matrix(film.page_scenes, 'scene'),
            '''{piece} seconds around every other cut between scenes were played in a window of 1280x720. Firefox and
            WebKit draw on a display in memory by software OpenGL, Chromium without a display; all use the two cores
            that also trace. Memory is the proportional set size of the process that shows the page.''',
            matrix(film.page_seen, 'G instructions a second'),
            '''What a viewer sees at 1280x720, simulated and judged as in "What a viewer sees, by machine and screen",
            for a twentieth of a second in each shot, but with the page's own player, one worker per core, and pictures
            that cost {ratio} times as much as natively: the PSNR in sRGB (dB) and FLIP. A core of x86-64 has 7 G.''']),
    Section(
        'scenes', 'The tracer: qualities, knobs, and the parts of a picture', 2.2,
        sources=['intro/base', 'intro/trace', 'intro/show', 'intro/transfer', 'tools/measure/bench'],
        programs=['tradeoff', 'trace_once'], packages=['valgrind'],
        parts=[
            tracer.qualities,
            '''Pictures of 1280x720, traced by traceFrame on one thread and compared with 256 samples a pixel: mean FLIP
            (67 pixels per degree), PSNR in linear light and in sRGB. **A** has ten balls on a checker with noise, two
            lights, mirrors and glass; other tracers can draw it as well (`trace_once pov A` prints it for POV-Ray). The
            other scenes are the film's.''',
            matrix(tracer.parts_of_pictures, 'M instructions at 320x180'),
            '''Posing builds the tree, and in the hall it also sums the light of the hour. Glare spreads light.
            Development turns linear light into the shown picture. The other rows are traceFrame at that quality.
            Callgrind counts on one thread.''',
            table(tracer.knobs, '''setting = A; cpu_ms = ms; instructions = M instructions at 320x180;
                mean_flip = mean FLIP; linear_psnr_db = linear dB; srgb_psnr_db = sRGB dB;
                samples_per_pixel = samples a pixel'''),
            '''The named qualities, plain grids, the governor's levels between qualities, and `play` with one knob
            changed at a time. A plain grid spends samples where the picture is smooth and lacks them where it is not,
            so the qualities are better at the same cost.''']),
    Section(
        'peers', 'Against POV-Ray and Embree', 1.5,
        sources=['intro/base', 'intro/trace', 'tools/measure/bench'],
        programs=['tradeoff', 'trace_once', 'compare', 'bench_hits'],
        packages=['povray', 'valgrind', 'libembree-dev'],
        parts=[
            tracer.against_povray('A'),
            tracer.against_povray('B'),
            '''One run of Debian's POV-Ray and of odraz. Each picture is compared with a picture of the same tracer with
            144 or 256 samples in every pixel: mean FLIP (67 pixels per degree), PSNR in linear light and in sRGB.
            POV-Ray's times and instructions are for its whole run, which also reads the scene and writes the picture.
            "Times at equal FLIP" is the time relative to that of odraz at the same error, which is interpolated in
            logarithms between odraz's qualities; there is none where no two of them enclose the error.
            **B**, a sphereflake of 7,381 balls, has edges in every pixel.''',
            table('build/bench_hits', '''scene; rays; odraz = odraz: M hits a second; embree = Embree; times;
                millions = M rays; differ = rays that differ'''),
            '''Closest hits on one thread, at 1280x720, by packets of eight rays in both tracers. First rays share a
            beam for 16x16 pixels in odraz, and have the flag for coherent rays in Embree 3. Reflections are of packets
            that all hit something. In Embree balls are its spheres and planes its quads. Rays differ if their distances
            do by more than a thousandth.''']),
    Section(
        'packers', 'The packer against others, and what search, contexts and memory buy', 1.6,
        sources=['packer', 'tools/measure/bench/bench_pack.cpp'],
        programs=['bench_pack', 'pack'], packages=['xz-utils', 'zstd', 'brotli', 'zpaq', 'valgrind'],
        parts=[
            methods.packers,
            methods.pack_instructions,
            '''Payloads, in bytes, of parts of the instructions of this film and of system libraries. The packer uses
            its default contexts without a search. The last row uses the contexts that ship, which may be newer.
            Packers and libraries that are not installed are left out. The last columns are this packer's payload
            relative to xz's and zpaq's, and its speed. Makers of intros use other packers, which cannot be measured
            on the same code: Crinkler (4 KB) and kkrunchy (64 KB) make 32-bit programs for Windows; squishy packs
            programs for Windows; oneKpaq and upkr have decoders of some hundred bytes, for intros of 1 to 8 KB. UPX
            packs any program, by LZMA at best, which is xz's method.''',
            table(methods.programs, '''program; file = bytes; xz = xz -9e --x86; packed; to_xz = to xz;
                start = s to start; fast = `--fast`: packed; fast_xz = to xz; fast_start = s to start'''),
            '''Whole programs of Debian, packed with the default contexts. A start is `--version`, in processor
            seconds, decoding included.''',
            table(methods.models, '''; payload = payload in bytes; encode_s = s to encode;
                decode_kb_s = KB decoded a second; memory_mb = MB'''),
            '''The whole film. "Contexts" and "slots" start from the contexts that ship; if the number of contexts
            changes, a short search adapts them. "Search" starts from contexts of two to four neighbouring fields each,
            since the contexts that ship are already the result of a search.''']),
    Section(
        'radiosity', "Radiosity: whole solutions of the thesis's sizes", 2.2,
        sources=['intro/radiosity', 'tools/radiosity', 'tools/measure/reference/radiosity_errors.cpp'],
        programs=['radiosity', 'radiosity_errors'], packages=[*RADIOSITY, 'valgrind'],
        parts=[
            table(methods.solutions, '''model; triangle = triangles; polygon = polygons; element = elements;
                sites = sites or patches; ray = rays from each;
                thesis = the thesis, s; seconds = odraz, s; each = us a triangle;
                median = median of 1,000 places, %; rms = rms, %'''),
            methods.columns,
            '''Whole solutions, without reading the model: by rays from every site, or, where the row says so, by
            hemicubes over patches, the thesis's method and the film's. Triangles of one plane are joined to polygons
            first, so the time depends on the elements: "columns" has at least as many as triangles. The thesis's
            seconds are for 100 x 100 pixels on a dual-core Athlon with a GeForce 7600 GT. In "cave" no two triangles
            lie in one plane, and many of them are lamps. "Vault" and "terrain" have many small planes. Rows
            with errors have the median time of three runs. Errors are against path tracing, at points spread by area;
            the noise of path tracing is subtracted from the rms.''']),
    Section(
        'hall', "The hall's light, against path tracing; and the transfer of any model", 2.9,
        sources=['intro/radiosity', 'intro/transfer', 'intro/show/daylight.cpp', 'intro/show/hall.h',
                 'intro/show/hall.cpp', 'intro/show/hall_model.cpp', 'tools/radiosity',
                 'tools/measure/bench/bench_transfer.cpp', 'tools/measure/reference'],
        programs=['hall_light', 'bench_transfer', 'trace_once', 'radiosity'],
        packages=[*RADIOSITY, 'libglfw3-dev', 'xvfb', 'valgrind'],
        parts=[
            methods.hall,
            '''The film's hall, at the settings that ship, against path tracing in double precision: the same model and
            light, each material's mean reflectance. Reflected light is what surfaces have reflected at least once. All
            light includes what the tracer draws, the direct light of the sun and of the point, which is taken from the
            paths on both sides. Texels are spread by area. Each has the mean of its visible sample points, where the
            light is interpolated and where paths start. The rms is a share of the light's root mean square, net of the
            paths' noise. The 95 of 100 are relative errors of single texels, with that noise: the largest are in deep
            shade. Lanterns and strips have radiance 1. The point is solved as the lanterns nearest to it are, which is
            most of its error.''',
            '''All rows but the last are differences between two solutions, of which the second is better in one thing;
            the last is what remains: patches that are still too wide, and direct light on them from four points a
            texel. Their squares do not quite sum up to the error's, since a part of each is in the next.''',
            '''The last table changes the raster or the patches. The setting in bold ships. A finer raster hardly shows:
            what is off is the light between the centres of patches. With cells of .2 m in the openings of the windows,
            where lit surfaces meet, reflected light was 12.1 % off at noon and in the evening, in 5 % less time; now
            they are .14 m wide. Half as wide patches everywhere take three times as long. Rays are faster up to 24
            pixels. Both methods have OpenGL's errors here. The program draws its hemicubes, the page traces them.''',
            lambda machine: machine.run('build/bench_transfer').strip(),
            methods.posing,
            matrix(methods.environments, 'the vault by environment and bands: rms %, by rows / by clusters'),
            methods.subspaces,
            '''The vault has {vault} and the default number of clusters, four for each function of the bands. The second
            table has five bands, stored in the same memory as clusters (CPCA) or as one subspace (PCA). Each is
            compared with a solution for that light alone, made by the other solver from the same rays. "Of the light"
            is the worst of the five environments.''',
            table(methods.turning, 'light; rate = pictures a second; ms = processor ms a picture'),
            '''The hall of columns, {columns}, with a glossy floor and four lamps, on software OpenGL, while a sky turns
            that lights all bands. No sky is seen from the closed hall, but the work is the same.''']),
    Section(
        'proofs', 'What tests find, against closed forms and references', 0.5,
        sources=['intro', 'tests/support', 'tools/measure/reference', *(
            f'tests/unit/{room}' for room in ('base', 'radiosity', 'show', 'sound', 'trace', 'transfer'))],
        programs=[f'tests/{program}' for program in methods.PROOFS], packages=[*RADIOSITY, 'libgtest-dev'],
        parts=[
            table(methods.proofs, 'test; what; figure; limit = at most'),
            '''A test fails if its figure is larger. Errors of `Exhaustive` are absolute, relative, or, of log2 and pow,
            shares of the bound in intro/base/maths.h, in one float of 251. The hall's hemicubes, traced for the page
            and drawn for the film, are compared with rays, pixel by pixel. Motion is the median change of luma. A pixel
            is "wrong" if `play` shows another shape than a ray through its centre hits, "off" if it differs by more
            than 16 levels from the picture traced with no square wider than a pixel. "Misjudged" balls are hit or
            missed otherwise in double precision.''']),
]
