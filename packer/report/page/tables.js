// The tables: rooms, files, symbols, sections and, from the disassembly, kinds of instructions.
let shownTable = 'symbols', sortedBy = 'packed', descending = true, shownRows = 200;

const columns = {
    name: {title: 'name', value: row => row.name.toLowerCase()},
    packed: {
        title: 'packed',
        value: row => row.units,
        show: row => number(inBytes(row.units), 1),
        tip: 'bytes of the packed file'
    },
    bytes: {
        title: 'unpacked',
        value: row => row.bytes,
        show: row => row.bytes ? number(row.bytes) : '',
        tip: 'bytes of the program'
    },
    bits: {title: 'bits a byte', value: row => bitsEach(row) || 0, show: row => number(bitsEach(row), 2)},
    part: {
        title: '%',
        value: row => row.units,
        show: row => number(100 * inBytes(row.units) / report.file, 1),
        tip: 'of the packed file'
    },
    count: {title: 'times', value: row => row.count, show: row => row.count ? number(row.count) : ''},
    change: {
        title: 'change',
        value: row => row.units - row.was,
        show: row => signed(inBytes(row.units - row.was), 1),
        signed: true,
        tip: 'bytes of the packed file'
    },
    counted: {
        title: 'counted',
        value: row => row.counted,
        show: row => number(row.counted),
        tip: 'packed bytes, with a proportional part of the bytes that no room names; to compare with the share'
    },
    share: {
        title: 'share',
        value: row => row.share ?? -1,
        show: row => row.share === null ? '' : number(row.share),
        tip: 'bytes that the room may take'
    },
    left: {
        title: 'left',
        value: row => row.share === null ? Infinity : row.share - row.counted,
        signed: true,
        flip: true,
        show: row => row.share === null ? '' : signed(row.share - row.counted)
    },
};
const tables = {
    rooms:
        {title: 'rooms', rows: () => report.rooms, columns: 'name counted share left change packed bytes bits part'},
    objects: {title: 'files', rows: () => report.objects, columns: 'name packed bytes bits part change'},
    symbols: {title: 'symbols', rows: () => report.symbols, columns: 'name packed bytes bits part change'},
    sections: {title: 'sections', rows: () => report.sections, columns: 'name packed bytes bits part change'},
    kinds: {title: 'instructions', rows: kindsOfInstructions, columns: 'name packed bytes bits part count'},
};

// Divides the bytes that no room names among the rooms, in proportion to their size.
function countRooms() {
    const stub = row => !row.stretches.length && !row.name.startsWith('(end');
    const own = report.rooms.filter(row => row.stretches.length && !row.name.startsWith('('));
    const sum = own.reduce((all, row) => all + row.units, 0);
    const rest = report.rooms.reduce((all, row) => all + (stub(row) ? 0 : row.units), 0);
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
        const row = byName.get(name), cost = costs.subarray(at, end).reduce((sum, c) => sum + c, 0);
        ++row.count;
        row.bytes += end - at;
        row.units += cost;
        row.stretches.push({begin: at, size: end - at});
        size -= end - at;
        units -= cost;
    }
    return kindRows = [...byName.values(), {name: '(no instructions)', units, bytes: size, count: 0, stretches: []}];
}

const hasShares = () => report.rooms.some(row => row.share !== null);
function columnsOf(table) {
    return tables[table].columns.split(' ').filter(
        name => name === 'change'                       ? tables[table].rows().some(row => row.was !== null) :
            ['counted', 'share', 'left'].includes(name) ? hasShares() :
                                                          true);
}

function showTable() {
    const names = columnsOf(shownTable), filter = $('filter').value.toLowerCase();
    if (!names.includes(sortedBy)) sortedBy = 'packed';
    const value = columns[sortedBy].value;
    const rows = tables[shownTable].rows().filter(row => row.name.toLowerCase().includes(filter));
    rows.sort((a, b) => (value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0) * (descending ? -1 : 1));
    const table = make('table'), head = table.createTHead().insertRow();
    for (const name of names) {
        const cell = make('th'), button = make('button', columns[name].title);
        button.title = columns[name].tip ?? '';
        if (name === sortedBy) {
            button.textContent += descending ? ' \u25be' : ' \u25b4';
            cell.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
        }
        button.onclick = () => {
            descending = name === sortedBy ? !descending : name !== 'name';
            sortedBy = name;
            showTable();
            $('table').querySelector(`th[aria-sort] button`).focus();
        };
        cell.append(button);
        head.append(cell);
    }
    const body = table.createTBody();
    for (const row of rows.slice(0, shownRows)) fillRow(body.insertRow(), names, row);
    const total =
        {name: filter ? `${number(rows.length)} that match` : 'the file', stretches: [], share: null, counted: 0};
    for (const key of ['units', 'bytes', 'was', 'count'])
        total[key] = rows.reduce((all, row) => all + (row[key] ?? 0), 0);
    total.counted = rows.reduce((all, row) => all + (row.counted ?? 0), 0);
    fillRow(table.createTFoot().insertRow(), names, total);
    $('table').replaceChildren(table);
    if (rows.length > shownRows) {
        const all = make('button', `show all ${number(rows.length)}`);
        all.onclick = () => {
            shownRows = Infinity;
            showTable();
        };
        $('table').append(all);
    }
    for (const tab of $('tabs').children) tab.setAttribute('aria-selected', tab.dataset.table === shownTable);
}

function fillRow(line, names, row) {
    for (const name of names) {
        const column = columns[name], cell = line.insertCell();
        if (name === 'name') {
            cell.title = row.name;
            if (row.stretches.length) {
                const button = make('button', row.name);
                button.onclick = () => choose(row.name, row.stretches);
                cell.append(button);
            } else
                cell.textContent = row.name;
            continue;
        }
        cell.textContent = column.show(row);
        if (column.signed) {
            const worse = column.flip ? -column.value(row) : column.value(row);
            if (Number.isFinite(worse) && Math.abs(inBytes(worse)) >= (column.flip ? 0 : 0.05))
                cell.className = worse > 0 ? 'more' : 'less';
        }
        if (name === 'bits' && row.bytes) {
            const swatch = make('i');
            swatch.style.cssText = `width:9px;margin-left:5px;background:${css(heat(bitsEach(row)))}`;
            cell.append(swatch);
        }
    }
}

function startTables() {
    countRooms();
    for (const name in tables) {
        if (name !== 'kinds' ? !report[name].length : !instructions.length) continue;
        const tab = make('button', tables[name].title);
        tab.setAttribute('role', 'tab');
        tab.dataset.table = name;
        tab.onclick = () => {
            shownTable = name;
            shownRows = 200;
            showTable();
            $('table').scrollTop = 0;
        };
        $('tabs').append(tab, ' ');
    }
    const named = report.symbols.some(row => row.stretches.length && !row.name.startsWith('(nothing named'));
    shownTable = hasShares() ? 'rooms' : named ? 'symbols' : 'sections';
    $('filter').oninput = showTable;
    showTable();
}
