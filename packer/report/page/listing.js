// The listing: bits, hex bytes coloured by cost, and instructions. Only visible lines are made.
const lineHeight = 18, dataWidth = 16;
// The first byte and the kind of each line: 0 data, 1 an instruction, 2 the name of the next symbol, 3 zeros
let lineAt = [], lineKind = [], firstLine = 0;

function buildLines() {
    let i = 0, at = 0, before = null;
    const push = (begin, kind) => {
        lineAt.push(begin);
        lineKind.push(kind);
    };
    for (const stretch of report.stretches) {
        const end = stretch.begin + stretch.size;
        if (at >= end) continue;
        at = Math.max(at, stretch.begin);
        if (!before || before.symbol !== stretch.symbol || before.object !== stretch.object) push(at, 2);
        before = stretch;
        while (at < end) {
            while (instructions[i]?.at < at) ++i;
            if (instructions[i]?.at === at) {
                push(at, 1);
                at = instructions[i].end;
                continue;
            }
            const stop = Math.min(end, instructions[i]?.at ?? end);
            let zeros = at;
            while (zeros < stop && !bytes[zeros]) ++zeros;
            if (zeros - at > 4 * dataWidth) {
                push(at, 3);
                at = zeros;
            } else {
                push(at, 0);
                at = Math.min(stop, at + dataWidth - (report.base + at) % dataWidth);
            }
        }
    }
    lineAt = Uint32Array.from(lineAt);
    lineKind = Uint8Array.from(lineKind);
}

const lineEnd = line => {
    for (++line; line < lineAt.length && lineKind[line] === 2;) ++line;
    return line < lineAt.length ? lineAt[line] : bytes.length;
};
const linesInView = () => Math.max(1, Math.floor($('listing').clientHeight / lineHeight));
// Returns the range of visible bytes.
function listedBytes() {
    const last = Math.min(lineAt.length, firstLine + linesInView()) - 1;
    return last < 0 ? [0, 0] : [lineAt[firstLine], lineEnd(last)];
}
// Browsers limit the height of an element: a very long listing is shorter than its lines and scrolls faster
const listingHeight = () => Math.min(lineAt.length * lineHeight, 8e6);

function scrollListingTo(at) {
    const line = Math.max(0, countBelow(at + 1, lineAt.length, i => lineAt[i]) - 1);
    const wanted = Math.max(0, line - Math.floor(linesInView() / 3)),
          most = Math.max(1, lineAt.length - linesInView());
    $('listing').scrollTop = Math.ceil(Math.min(1, wanted / most) * (listingHeight() - $('listing').clientHeight));
}

function fillLine(line, div) {
    const kind = lineKind[line], begin = lineAt[line], stretch = stretchAt(begin);
    if (kind === 2) {
        const all = stretch.symbol.stretches.filter(s => s.object === stretch.object);
        const units = sumOf(all, s => s.units), size = sumOf(all, s => s.size);
        div.className = 'name';
        div.title = stretch.symbol.name;
        const where = [stretch.object?.name, stretch.room?.name].filter(name => name && !name.startsWith('('));
        div.append(
            make('span', stretch.symbol.name), make('span', where.join(', '), 'soft'),
            make('span', `${number(inBytes(units), 1)} bytes of ${number(size)}`, 'soft'));
        return;
    }
    const end = lineEnd(line), hexes = make('span', '', 'hex');
    let units = 0, letters = '';
    for (let at = begin; at < end; ++at) {
        units += costs[at];
        if (kind === 3) continue;
        const colour = heatOf(costs[at]), style = `background:${css(colour)};color:${inkOn(colour)}`;
        hexes.append(make('b', hex(bytes[at], 2), at === cursor ? 'cursor' : '', {style, at}));
        letters += bytes[at] > 31 && bytes[at] < 127 ? String.fromCharCode(bytes[at]) : '\u00b7';
    }
    if (cursor >= begin && cursor < end) div.className = 'here';
    if (kind === 3) hexes.textContent = `00, ${number(end - begin)} times`;
    const text = make('span', '', 'text');
    if (kind === 1) {
        // The target of a jump or of an operand relative to rip is last
        const {text: all} = instructions[instructionFrom(begin)];
        const [, before, last] = /^(.* )([0-9a-f]+)$/.exec(all) ?? [];
        const target = parseInt(last, 16) - report.base;
        if (target >= 0 && target < bytes.length) {
            const href = `#${address(target)}`, title = `${address(target)}: ${locationOf(target)}`;
            text.append(before, make('a', locationOf(target, shortName), '', {href, title}));
        } else
            text.append(all);
    } else if (kind === 0)
        text.textContent = letters;
    div.append(make('span', address(begin), 'at'), make('span', number(units / report.unit, 1), 'bits'), hexes, text);
}

function showListing() {
    if (!bytes.length) return;
    const {scrollTop, clientHeight} = $('listing'), most = Math.max(0, lineAt.length - linesInView());
    firstLine = Math.min(most, Math.round(scrollTop / Math.max(1, listingHeight() - clientHeight) * most));
    $('lines').replaceChildren();
    for (let line = firstLine; line < Math.min(lineAt.length, firstLine + linesInView()); ++line) {
        $('lines').append(make('div'));
        fillLine(line, $('lines').lastChild);
    }
}

function startListing() {
    $('code_note').textContent = instructions.length ?
        `${number(instructions.length)} instructions; bits, bytes, objdump's text` :
        'no instructions: objdump was not installed, or found none';
    if (!bytes.length) return;
    buildLines();
    $('listing').append(make('div', '', '', {style: `height:${listingHeight()}px`}));
    $('listing').firstChild.append(make('div', '', '', {id: 'lines'}));
    $('listing').onscroll = () => {
        showListing();
        drawHeat();
    };
    $('listing').onclick = event => {
        if (event.target.at !== undefined) goTo(event.target.at, false);
    };
    showTips('listing', event => tipOfByte(event.target.at));
    let last = '', next = 0;
    $('find').onkeydown = event => {
        const text = $('find').value.trim();
        if (event.key !== 'Enter' || !text) return;
        const at = /^(0x)?[0-9a-f]+$/i.test(text) ? parseInt(text.replace(/^0x/i, ''), 16) - report.base : -1;
        if (at >= 0 && at < bytes.length) return goTo(at);
        // The same text again: go to the next name that contains it
        next = text === last ? next + 1 : 0;
        last = text;
        const found =
            report.symbols.filter(row => row.stretches.length && row.name.toLowerCase().includes(text.toLowerCase()));
        const row = found[next % found.length];
        if (row) choose(row.name, row.stretches);
        else $('chosen').textContent = `There is no address or name ${text}.`;
    };
}
