// What assistive technology is told of a page: the browser's own accessibility tree as lines of text,
// one for each node that has a meaning: role, name, value, states, description.

const passedThrough = new Set(['none', 'generic', 'InlineTextBox', 'LineBreak', 'presentation', 'GenericContainer']);
const states = ['checked', 'pressed', 'expanded', 'disabled', 'invalid', 'selected', 'readonly', 'level', 'modal', 'live'];
const unsaid = new Set([undefined, '', false, 'false', 'off']);
/** Of these only the false one says something. */
const saidEitherWay = new Set(['checked', 'pressed', 'expanded']);

const text = (value) => String(value ?? '').replace(/\s+/g, ' ').trim();

function stateOf({ properties = [] }, name) {
    const value = properties.find((property) => property.name === name)?.value?.value;
    if (saidEitherWay.has(name) ? value === undefined : unsaid.has(value)) return [];
    return [value === true || value === 'true' ? name : `${name}=${value}`];
}

/** Browsers hold numbers as floats; a field that one types in has its value as a text below it. */
function valueOf({ role, value, valueText }) {
    if (role.value === 'spinbutton') return '';
    const number = value?.value;
    return text(valueText ?? (typeof number === 'number' ? Number(number.toPrecision(6)) : number));
}

function lineOf(node) {
    const value = valueOf(node);
    const description = text(node.description?.value);
    return [
        node.role.value, `"${text(node.name?.value)}"`,
        ...value ? [`= ${value}`] : [],
        ...states.flatMap((name) => stateOf(node, name)).map((state) => `[${state}]`),
        ...description ? [`(${description})`] : [],
    ].join(' ');
}

/** The text of a node and of all below it. */
function wordsOf(node, children) {
    if (node.role.value === 'StaticText') return text(node.name?.value);
    return children(node).map((child) => wordsOf(child, children)).filter(Boolean).join(' ');
}

function linesOf(node, children, indent, parentName) {
    const role = node.role?.value;
    const below = (next, name) => children(node).flatMap((child) => linesOf(child, children, next, name));
    if (node.ignored || passedThrough.has(role)) return below(indent, parentName);
    const name = text(node.name?.value);
    if (role === 'StaticText') return name === '' || name === parentName ? [] : [`${indent}text "${name}"`];
    if (/^math/i.test(role)) return [`${indent}math "${wordsOf(node, children)}"`];
    return [indent + lineOf(node), ...below(`${indent}  `, name)];
}

/** What sliders say instead of their numbers, which the browser's tree leaves out. */
async function addValueTexts(devtools, nodes) {
    for (const slider of nodes.filter(({ role }) => role?.value === 'slider')) {
        const { node } = await devtools.send('DOM.describeNode', { backendNodeId: slider.backendDOMNodeId });
        const at = node.attributes.indexOf('aria-valuetext');
        if (at >= 0) slider.valueText = node.attributes[at + 1];
    }
}

/**
 * The tree of a page, without the page itself.
 * @param {import('playwright-core').Page} page
 */
export async function accessibilityTree(page) {
    const devtools = await page.context().newCDPSession(page);
    const { nodes } = await devtools.send('Accessibility.getFullAXTree');
    await addValueTexts(devtools, nodes);
    await devtools.detach();
    const byId = new Map(nodes.map((node) => [node.nodeId, node]));
    const children = (node) => (node.childIds ?? []).map((id) => byId.get(id)).filter(Boolean);
    return `${children(nodes[0]).flatMap((node) => linesOf(node, children, '', '')).join('\n')}\n`;
}
