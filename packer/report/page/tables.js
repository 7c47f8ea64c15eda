// The tables: rooms, files, symbols, sections and, from the disassembly, kinds of instructions.
let shownTable = 'symbols', sortedBy = 'packed', descending = true, shownRows = 200;

// A column: its title, the value to sort by, the text of a cell, a tip. `sign`: 1 if more is worse, -1 if less is.
const column = (title, value, show, tip = '', sign = 0) => ({title, value, show, tip, sign});
const columns = {
    name: column('name', row => row.name.toLowerCase()),
    packed: column('packed', row => row.units, row => number(inBytes(row.units), 1), 'bytes of the packed file'),
    bytes: column('unpacked', row => row.bytes, row => row.bytes ? number(row.bytes) : '', 'bytes of the program'),
    bits: column('bits a byte', row => bitsEach(row) || 0, row => number(bitsEach(row), 2)),
    part: column('%', row => row.units, row => number(100 * inBytes(row.units) / report.file, 1), 'of the packed file'),
    count: column('times', row => row.count, row => row.count ? number(row.count) : ''),
    change: column('change', row => row.units - row.was, row => signed(inBytes(row.units - row.was), 1),
        'bytes of the packed file', 1),
    counted: column('counted', row => row.counted, row => number(row.counted),
        'packed bytes, with a proportional part of the bytes that no room names; to compare with the share'),
    share: column('share', row => row.share ?? -1, row => row.share === null ? '' : number(row.share),
        'bytes that the room may take'),
    left: column('left', row => row.share === null ? Infinity : row.share - row.counted,
        row => row.share === null ? '' : signed(row.share - row.counted), '', -1),
};
const partColumns = 'name packed bytes bits part change';
const tables = {
    rooms: {title: 'rooms', rows: () => report.rooms, columns: 'name counted share left change packed bytes bits part'},
    objects: {title: 'files', rows: () => report.objects, columns: partColumns},
    symbols: {title: 'symbols', rows: () => report.symbols, columns: partColumns},
    sections: {title: 'sections', rows: () => report.sections, columns: partColumns},
    kinds: {title: 'instructions', rows: kindsOfInstructions, columns: 'name packed bytes bits part count'},
};

// Divides the bytes that no room names among the rooms, in proportion to their size.
function countRooms() {
    const stub = row => !row.stretches.length && !row.name.startsWith('(end');
    const own = report.rooms.filter(row => row.stretches.length && !row.name.startsWith('('));
    const sum = sumOf(own, row => row.units), rest = sumOf(report.rooms, row => stub(row) ? 0 : row.units);
    for (const row of report.rooms)
        row.counted = own.includes(row) ? inBytes(row.units / sum * rest) : stub(row) ? inBytes(row.units) : 0;
}

// Returns instructions by name, and a row for everything else, so that the sum is the file.
let kindRows;
function kindsOfInstructions() {
    if (kindRows) return kindRows;
    const byName = new Map();
    let units = inUnits(report.file), size = bytes.length;
    for (const {at, end, text} of instructions) {
        const name = text.split(' ')[0];
        if (!byName.has(name)) byName.set(name, {name, units: 0, bytes: 0, count: 0, stretches: []});
        const row = byName.get(name), cost = sumOf(costs.subarray(at, end), units => units);
        ++row.count;
        addTo(row, {begin: at, size: end - at, units: cost});
        size -= end - at;
        units -= cost;
    }
    return kindRows = [...byName.values(), {name: '(no instructions)', units, bytes: size, count: 0, stretches: []}];
}

const hasShares = () => report.rooms.some(row => row.share !== null);
const hasChanges = rows => rows.some(row => row.was !== null);
const needs = {change: hasChanges, counted: hasShares, share: hasShares, left: hasShares};  // what a column shows
const columnsOf = ({columns, rows}) => columns.split(' ').filter(name => needs[name]?.(rows()) ?? true);

function showTable() {
    const names = columnsOf(tables[shownTable]), filter = $('filter').value.toLowerCase();
    if (!names.includes(sortedBy)) sortedBy = 'packed';
    const value = columns[sortedBy].value;
    const rows = tables[shownTable].rows().filter(row => row.name.toLowerCase().includes(filter));
    rows.sort((a, b) => (value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0) * (descending ? -1 : 1));
    const table = make('table'), head = table.createTHead().insertRow();
    for (const name of names) {
        const {title, tip} = columns[name], cell = make('th'), mark = descending ? ' \u25be' : ' \u25b4';
        if (name === sortedBy) cell.ariaSort = descending ? 'descending' : 'ascending';
        cell.append(makeButton(name === sortedBy ? title + mark : title, () => {
            descending = name === sortedBy ? !descending : name !== 'name';
            sortedBy = name;
            showTable();
            $('table').querySelector(`th[aria-sort] button`).focus();
        }, {title: tip}));
        head.append(cell);
    }
    const body = table.createTBody();
    for (const row of rows.slice(0, shownRows)) fillRow(body.insertRow(), names, row);
    const total = {name: filter ? `${number(rows.length)} that match` : 'the file', stretches: [], share: null};
    for (const key of ['units', 'bytes', 'was', 'count', 'counted']) total[key] = sumOf(rows, row => row[key] ?? 0);
    fillRow(table.createTFoot().insertRow(), names, total);
    $('table').replaceChildren(table);
    if (rows.length > shownRows)
        $('table').append(makeButton(`show all ${number(rows.length)}`, () => {
            shownRows = Infinity;
            showTable();
        }));
    for (const tab of $('tabs').children) tab.ariaSelected = tab.table === shownTable;
}

function fillRow(line, names, row) {
    for (const name of names) {
        const column = columns[name], cell = line.insertCell();
        if (name === 'name') {
            cell.title = row.name;
            cell.append(row.stretches.length ? makeButton(row.name, () => choose(row.name, row.stretches)) : row.name);
            continue;
        }
        cell.textContent = column.show(row);
        if (column.sign && /[1-9]/.test(cell.textContent))
            cell.className = column.sign * column.value(row) > 0 ? 'more' : 'less';
        if (name === 'bits' && row.bytes) {
            const style = `width:9px;margin-left:5px;background:${css(heat(bitsEach(row)))}`;
            cell.append(make('i', '', '', {style}));
        }
    }
}

function startTables() {
    countRooms();
    for (const name in tables) {
        if (name !== 'kinds' ? !report[name].length : !instructions.length) continue;
        $('tabs').append(makeButton(tables[name].title, () => {
            shownTable = name;
            shownRows = 200;
            showTable();
            $('table').scrollTop = 0;
        }, {role: 'tab', table: name}), ' ');
    }
    const named = report.symbols.some(row => row.stretches.length && !row.name.startsWith('(nothing named'));
    shownTable = hasShares() ? 'rooms' : named ? 'symbols' : 'sections';
    $('filter').oninput = showTable;
    showTable();
}
