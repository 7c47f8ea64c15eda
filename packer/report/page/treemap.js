// The treemap: rooms, files, functions; without a map, sections and functions.
let root, shownNode, byChange = false;

function buildTree() {
    const node = (name, part, up) => ({name, part, up, units: 0, bytes: 0, children: new Map(), stretches: []});
    root = node(report.name, null, null);
    for (const stretch of report.stretches) {
        const {room, object, section, symbol} = stretch, levels = object ? [room, object, symbol] : [section, symbol];
        let at = root;
        addTo(at, stretch);
        for (const part of levels) {
            if (!at.children.has(part)) at.children.set(part, node(part.name, part, at));
            at = at.children.get(part);
            addTo(at, stretch);
        }
    }
    // Add stub and payload's end, which do not belong to the program
    for (const row of report.sections)
        if (!row.stretches.length && row.units) {
            const child = node(row.name, row, root);
            child.units = row.units;
            root.units += row.units;
            root.children.set(row, child);
        }
    const sort = at => {
        at.children = [...at.children.values()].sort((a, b) => b.units - a.units);
        at.children.forEach(sort);
        // Skip a level whose only part has the same name or no name
        const [only, ...others] = at.children;
        if (only && !others.length && (only.name === at.name || only.name.startsWith('(nothing named')))
            at.children = only.children;
    };
    sort(root);
}

const leastArea = 12;  // smaller boxes, in square pixels, are not drawn

// Divides a rectangle among nodes, which are ordered by size. Halves the nodes by size and cuts the longer side of the
// rectangle, then divides both parts in the same way. Calls draw(node, x, y, width, height).
function divide(nodes, x, y, width, height, draw) {
    const all = nodes.filter(n => n.units > 0), sum = all.reduce((all, n) => all + n.units, 0);
    if (!all.length || width * height < leastArea) return;
    if (all.length === 1) return draw(all[0], x, y, width, height);
    let count = 1, first = all[0].units;
    while (count < all.length - 1 && first + all[count].units / 2 < sum / 2) first += all[count++].units;
    const wide = width > height, part = first / sum, right = wide ? width * part : 0, down = wide ? 0 : height * part;
    divide(all.slice(0, count), x, y, right || width, down || height, draw);
    divide(all.slice(count), x + right, y + down, width - right, height - down, draw);
}

function colourOf(node) {
    if (!byChange) return node.bytes ? heat(bitsEach(node)) : [112, 120, 134];
    const part = node.part, change = part.was === null ? 0 : part.units - part.was;
    if (!change) return [58, 64, 74];
    const much = Math.min(1, Math.abs(inBytes(change)) / 32);
    return change > 0 ? [58 + 190 * much, 64 + 30 * much, 74 - 20 * much].map(Math.round) :
                        [58 - 20 * much, 64 + 140 * much, 74 + 20 * much].map(Math.round);
}

function drawNode(node, x, y, width, height, depth) {
    if (width < 2 || height < 2) return;
    const label = width > 30 && height > 15 ? shortName(node.name) : '';
    const style = `left:${x}px;top:${y}px;width:${width}px;height:${height}px`;
    const box = make('div', label, '', {style, node});
    if (depth === 1)
        Object.assign(
            box, {tabIndex: 0, role: 'button', ariaLabel: `${node.name}, ${number(inBytes(node.units))} bytes`});
    $('map').append(box);
    if (node.children.length && width > 40 && height > 34) {
        box.className = 'group';
        if (label && width > 90) box.textContent += `  ${number(inBytes(node.units))}`;
        divide(node.children, x + 1, y + 16, width - 2, height - 17, (n, ...r) => drawNode(n, ...r, depth + 1));
    } else {
        const colour = colourOf(node);
        box.style.background = css(colour);
        box.style.color = inkOn(colour);
    }
}

function showTree(node = shownNode) {
    shownNode = node;
    $('map').replaceChildren();
    const {clientWidth, clientHeight} = $('map');
    divide(
        node.children.length ? node.children : [node], 0, 0, clientWidth, clientHeight,
        (n, ...r) => drawNode(n, ...r, 1));
    const path = [];
    for (let up = node; up; up = up.up) path.unshift(makeButton(up.name, () => openNode(up)), ' ');
    const change = changeOf(node) ? `, ${changeOf(node)}` : '';
    path.push(make('span', `${number(inBytes(node.units), 1)} bytes${change}`, 'soft'));
    $('path').replaceChildren(...path);
}

// Zooms to a group, and highlights the bytes of any node.
function openNode(node) {
    if (node.children.length) showTree(node);
    if (node === root) choose();
    else choose(node.name, node.stretches);
}

const changeOf = ({part}) => part && part.was !== null ? signed(inBytes(part.units - part.was), 1) : '';
function tipOfNode(node) {
    if (!node) return '';
    const lines = [
        node.name,
        `${number(inBytes(node.units), 1)} bytes, ${number(100 * inBytes(node.units) / report.file, 2)} % of the file`
    ];
    if (node.bytes) lines.push(`${number(node.bytes)} unpacked, ${number(bitsEach(node), 2)} bits a byte`);
    if (changeOf(node)) lines.push(`${changeOf(node)} bytes`);
    if (node.children.length) lines.push(`${node.children.length} parts: click to zoom`);
    return lines.join('\n');
}

function startTree() {
    buildTree();
    const nodeOf = event => event.target.closest('#map div')?.node;
    $('map').onclick = event => {
        const node = nodeOf(event);
        if (node) openNode(node);
    };
    $('map').onkeydown = event => {
        if (event.key === 'Enter' || event.key === ' ') openNode(nodeOf(event) ?? root);
        else if ((event.key === 'Escape' || event.key === 'Backspace') && shownNode.up) showTree(shownNode.up);
        else return;
        event.preventDefault();
        $('map').firstChild?.focus();
    };
    showTips('map', event => tipOfNode(nodeOf(event)));
    const colour = change => {
        byChange = change;
        $('byBits').ariaPressed = !change;
        $('byChange').ariaPressed = change;
        showTree();
    };
    $('byBits').onclick = () => colour(false);
    $('byChange').onclick = () => colour(true);
    if (!report.before) $('byBits').hidden = $('byChange').hidden = true;
    showTree(root);
}
