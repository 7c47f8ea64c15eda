'use strict';
// The page's data. Costs are whole numbers of units. A bit has `report.unit` of them, so sums are exact.
let report;        // the tables, as report_html.cpp writes them
let bytes, costs;  // the program's bytes and the cost of each; empty if the program is too large to show
let instructions;  // [{at, end, text}, ...]

const $ = id => document.getElementById(id);

// Makes an element of the page, <div class="name">text</div>, with other properties.
const make = (tag, text = '', className = '', more = {}) =>
    Object.assign(document.createElement(tag), {textContent: text, className, ...more});
const makeButton = (text, onclick, more = {}) => make('button', text, '', {onclick, ...more});
const sumOf = (all, value) => all.reduce((sum, one) => sum + value(one), 0);

async function unpack(id) {
    const packed = Uint8Array.from(atob($(id).textContent), c => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

const kinds = {rooms: 'room', objects: 'object', sections: 'section', symbols: 'symbol'};  // table: its parts

async function readData() {
    const text = new TextDecoder();
    report = JSON.parse(text.decode(await unpack('tables')));
    report.stretches = report.stretches.map(([begin, size, units, section, object, room, symbol]) =>
        ({begin, size, units, section, object, room, symbol}));
    for (const kind in kinds) report[kind] = makeRows(kind);
    bytes = await unpack('bytes');
    costs = Uint16Array.from(await unpack('costs'));
    for (const [at, units] of report.high) costs[at] = units;
    readInstructions(text.decode(await unpack('code')));
}

const addTo = (part, stretch) => {
    part.bytes += stretch.size;
    part.units += stretch.units;
    part.stretches.push(stretch);
};

// Makes the rows of a table: the parts of both reports, stub and headers, and the payload's end. In each stretch, the
// row of its part replaces the name.
function makeRows(kind) {
    const rows = new Map(), before = report.before?.[kind], part = kinds[kind];
    const row = (name, was = before?.[name]) => {
        const share = kind === 'rooms' ? report.shares?.[name] ?? null : null;
        if (!rows.has(name))
            rows.set(name, {kind, name, bytes: 0, units: 0, was: before ? was ?? 0 : null, share, stretches: []});
        return rows.get(name);
    };
    for (const stretch of report.stretches) {
        if (!stretch[part]) return [];
        addTo(stretch[part] = row(stretch[part]), stretch);
    }
    for (const name in before) row(name);
    const rest = ({file, overhead}, units) => inUnits(file - overhead) - sumOf(units, one => one);
    const stub = kind === 'rooms' && report.stubRoom && !rows.has(report.stubRoom) ? report.stubRoom : '(stub)';
    row(stub, before && inUnits(report.before.overhead)).units = inUnits(report.overhead);
    row('(end of the payload)', before && rest(report.before, Object.values(before))).units =
        rest(report, report.stretches.map(stretch => stretch.units));
    return [...rows.values()];
}

// A line is the size and text of an instruction, or @ and the offset of the next one.
function readInstructions(code) {
    instructions = [];
    let end = 0;
    for (const line of code.split('\n').slice(0, -1)) {
        const at = end;
        if (line[0] === '@') end = parseInt(line.slice(1), 16);
        else instructions.push({at, end: end += parseInt(line[0], 16), text: line.slice(1)});
    }
}

// Returns the tables whose rows do not add up to the file; none if all is right.
function wrongSums() {
    const file = inUnits(report.file), sum = rows => sumOf(rows, row => row.units);
    const wrong = Object.keys(kinds).filter(kind => report[kind].length && sum(report[kind]) !== file);
    const program = sum(report.stretches);
    if (program + sum(report.sections.filter(row => !row.stretches.length)) !== file) wrong.push('stretches');
    if (report.shown && sumOf(costs, units => units) !== program) wrong.push('bytes');
    return wrong;
}

const inBytes = units => units / 8 / report.unit, inUnits = size => size * 8 * report.unit;
const bitsEach = part => part.bytes ? part.units / report.unit / part.bytes : NaN;
const number = (value, digits = 0) => Number.isNaN(value) ? '' : value.toLocaleString(
    'en', {minimumFractionDigits: digits, maximumFractionDigits: digits});
const signed = (value, digits = 0) => {
    const text = number(Math.abs(value), digits);
    return (/[1-9]/.test(text) ? value > 0 ? '+' : '\u2212' : '') + text;
};
const hex = (value, digits = 0) => value.toString(16).padStart(digits, '0');
const address = at => hex(report.base + at);

// Returns how many of `count` ascending values are below `limit`.
function countBelow(limit, count, valueOf) {
    let low = 0, high = count;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (valueOf(middle) < limit) low = middle + 1;
        else high = middle;
    }
    return low;
}
// Returns the stretch of a byte.
function stretchAt(at) {
    const next = countBelow(at + 1, report.stretches.length, i => report.stretches[i].begin);
    return report.stretches[Math.max(0, next - 1)];
}
// Returns "name+0x12" for an offset in the program.
function locationOf(at, named = name => name) {
    const stretch = stretchAt(at);
    const first = stretch.symbol.stretches[0].begin;
    return named(stretch.symbol.name) +
        (at > first && !stretch.symbol.name.startsWith('(') ? '+0x' + hex(at - first) : '');
}
// Returns the index of the instruction that begins at `at`, or of the next one.
const instructionFrom = at => countBelow(at, instructions.length, i => instructions[i].at);

// Shortens a name where there is little space: without parameters and the most common namespace.
let commonSpace;
function shortName(name) {
    if (name.startsWith('(') && !name.startsWith('(anonymous')) return name;
    if (commonSpace === undefined) {
        const times = new Map();
        for (const row of report.symbols) {
            const space = /^\w+::/.exec(row.name)?.[0] ?? '';
            times.set(space, (times.get(space) ?? 0) + 1);
        }
        commonSpace = [...times].sort((a, b) => b[1] - a[1])[0]?.[0] ?? '';
    }
    const plain = name.replace(/\(anonymous namespace\)::/g, '');
    return (plain.startsWith(commonSpace) ? plain.slice(commonSpace.length) : plain).replace(/\(.*$/, '') || name;
}

// Colours for bits a byte: [bits, red, green, blue].
const heatStops = [
    [0, 24, 34, 48], [0.5, 26, 66, 98], [2, 32, 128, 128], [4, 168, 182, 62], [6, 242, 158, 46], [8, 232, 66, 42],
    [12, 255, 196, 226], [1e9, 255, 255, 255]
];
function heat(bits) {
    let i = 1;
    while (heatStops[i][0] < bits) ++i;
    const [from, ...a] = heatStops[i - 1], [to, ...b] = heatStops[i];
    const part = Math.min(1, (bits - from) / (Math.min(to, 24) - from));
    return a.map((value, channel) => Math.round(value + part * (b[channel] - value)));
}
const css = ([r, g, b]) => `rgb(${r},${g},${b})`;
const inkOn = ([r, g, b]) => 0.3 * r + 0.59 * g + 0.11 * b > 110 ? '#10131a' : '#dfe3ea';
