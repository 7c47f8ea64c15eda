// All bytes as cells, coloured by cost, row by row. Only visible rows are drawn.
const gutter = 72;  // width of the addresses, in pixels
let cell, columnCount, canvas, cursor = 0;
let chosen = null;  // 1 for each byte of the chosen part; null: no part is chosen

const rowCount = () => Math.ceil(bytes.length / columnCount);

function layHeat() {
    if (!bytes.length) return;
    const width = $('heat').clientWidth - gutter;
    columnCount = Math.max(16, Math.floor(width / cell / 16) * 16);
    $('heat').firstChild.style.height = `${rowCount() * cell}px`;
    drawHeat();
}

function drawHeat() {
    if (!bytes.length) return;
    const {clientWidth: width, clientHeight: height, scrollTop} = $('heat'), scale = devicePixelRatio || 1;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    canvas.style.marginBottom = `${- height}px`;
    canvas.width = width * scale;
    canvas.height = height * scale;
    const context = canvas.getContext('2d');
    context.scale(scale, scale);
    context.imageSmoothingEnabled = false;
    const first = Math.floor(scrollTop / cell), rows = Math.min(rowCount() - first, Math.ceil(height / cell) + 1);
    const small = new OffscreenCanvas(columnCount, rows), image = new ImageData(columnCount, rows);
    for (let i = 0, at = first * columnCount; i < rows * columnCount && at < bytes.length; ++i, ++at) {
        const dim = chosen && !chosen[at] ? 0.25 : 1, colour = heatOf(costs[at]);
        for (let c = 0; c < 3; ++c) image.data[4 * i + c] = colour[c] * dim + 12 * (1 - dim);
        image.data[4 * i + 3] = 255;
    }
    small.getContext('2d').putImageData(image, 0, 0);
    const top = first * cell - scrollTop;
    context.drawImage(small, gutter, top, columnCount * cell, rows * cell);
    context.fillStyle = '#9aa4b2';
    context.font = '11px monospace';
    const every = Math.max(1, Math.ceil(48 / cell));
    for (let row = Math.ceil(first / every) * every; row < first + rows; row += every)
        context.fillText(address(row * columnCount), 4, row * cell - scrollTop + Math.max(9, cell / 2 + 4));
    // Mark the bytes of the listing, and the cursor
    const [from, to] = listedBytes();
    context.fillStyle = '#7ab7ff';
    context.fillRect(
        gutter - 5, Math.floor(from / columnCount) * cell - scrollTop, 3,
        Math.max(3, (Math.ceil(to / columnCount) - Math.floor(from / columnCount)) * cell));
    const x = gutter + cursor % columnCount * cell, y = Math.floor(cursor / columnCount) * cell - scrollTop;
    context.strokeStyle = '#fff';
    context.lineWidth = 2;
    context.strokeRect(x - 2, y - 2, cell + 4, cell + 4);
}

const heatCache = [];
const heatOf = units => heatCache[units] ??= heat(units / report.unit);

// Returns the byte under the mouse, or -1.
function byteUnder(event) {
    const box = $('heat').getBoundingClientRect();
    const column = Math.floor((event.clientX - box.left - gutter) / cell);
    const at = Math.floor((event.clientY - box.top + $('heat').scrollTop) / cell) * columnCount + column;
    return column >= 0 && column < columnCount && at >= 0 && at < bytes.length ? at : -1;
}

function tipOfByte(at) {
    if (!(at >= 0)) return '';
    const stretch = stretchAt(at),
          where = [stretch.object?.name, stretch.room?.name, stretch.section.name].filter(Boolean);
    const bits = number(costs[at] / report.unit, 2);
    return `${address(at)}: ${hex(bytes[at], 2)}, ${bits} bits\n${locationOf(at)}\n${where.join(', ')}`;
}

// Moves the cursor and scrolls both views to it.
function goTo(at, scrollListing = true) {
    if (!bytes.length) return;
    cursor = Math.max(0, Math.min(bytes.length - 1, at));
    const y = Math.floor(cursor / columnCount) * cell, view = $('heat');
    if (y < view.scrollTop || y + cell > view.scrollTop + view.clientHeight)
        view.scrollTop = y - view.clientHeight / 3;
    if (scrollListing) scrollListingTo(cursor);
    showListing();
    drawHeat();
}

// Highlights the bytes of a part; without a name, all bytes.
function choose(name, stretches = []) {
    chosen = null;
    if (name && stretches.length && bytes.length) {
        chosen = new Uint8Array(bytes.length);
        for (const s of stretches) chosen.fill(1, s.begin, s.begin + s.size);
        const units = costs.reduce((all, cost, at) => all + (chosen[at] ? cost : 0), 0);
        const size = sumOf(stretches, s => s.size);
        $('chosen').textContent = `${name}: ${number(inBytes(units), 1)} bytes, unpacked ${number(size)}, in ${
            number(stretches.length)} ${stretches.length === 1 ? 'place' : 'places'}`;
        goTo(stretches[0].begin);
    } else
        $('chosen').textContent = name ? `${name}: no part of the program, so it has no bytes here` :
                                         'Click a byte, a name in a table or a part of the map.';
    $('nothing').hidden = !chosen;
    drawHeat();
}

function startHeat() {
    $('below').hidden = !bytes.length;
    $('too_large').hidden = bytes.length;
    if (!bytes.length) return;
    canvas = make('canvas');
    $('heat').append(make('div'));
    $('heat').firstChild.append(canvas);
    const stops =
        heatStops.filter(([bits]) => bits <= 12).map(([bits, ...colour]) => `${css(colour)} ${bits / 12 * 100}%`);
    const style = `background:linear-gradient(90deg, ${stops.join(', ')})`;
    $('legend').append('0', make('i', '', '', {style}), '12 bits');
    const fits = size =>
        Math.ceil(bytes.length / Math.max(1, Math.floor(($('heat').clientWidth - gutter) / size))) * size <=
        $('heat').clientHeight;
    for (cell = 2; cell < 16 && fits(cell + 1);) ++cell;
    $('heat').onscroll = drawHeat;
    showTips('heat', event => tipOfByte(byteUnder(event)));
    $('heat').onclick = event => {
        const at = byteUnder(event);
        if (at >= 0) goTo(at);
    };
    $('heat').onkeydown = event => {
        const page = Math.floor($('heat').clientHeight / cell) * columnCount;
        const steps = {
            ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columnCount, ArrowDown: columnCount, PageUp: -page, PageDown: page,
            Home: -cursor, End: bytes.length - 1 - cursor
        };
        if (event.key in steps) goTo(cursor + steps[event.key]);
        else if (event.key === 'Escape') choose();
        else return;
        event.preventDefault();
    };
    const zoom = by => {
        cell = Math.max(1, Math.min(16, cell + by));
        layHeat();
        goTo(cursor, false);
    };
    $('smaller').onclick = () => zoom(-1);
    $('larger').onclick = () => zoom(1);
    $('nothing').onclick = () => choose();
    layHeat();
    choose();
}
