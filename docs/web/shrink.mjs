// shrink.mjs - reduces a shader to what a page uses of it, without comments and directives. The text is one that
// --print-shader=page printed: it compiles, and its macros have no parameters. Names stay long, because the shaders of a
// page share most functions, which compress to nothing if they are equal.

const TOKEN = /\s+|[A-Za-z_]\w*|0x[\da-fA-F]+u?|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[uUfF]?|<<=|>>=|\+\+|--|<<|>>|[-+*/%&|^=!<>]=|&&|\|\||\^\^|[^]/g;
const isWord = (token) => /^[A-Za-z_]/.test(token ?? '');
const tokensOf = (text) => (text.match(TOKEN) ?? []).filter((token) => token.trim() !== '');

// ---- Directives ----

// The tokens with all macros expanded.
const expanded = (tokens, macros, within = []) => tokens.flatMap((token) => macros.has(token) && !within.includes(token) ? expanded(macros.get(token), macros, [...within, token]) : [token]);

// The value of the condition of an #if.
function holds(condition, macros) {
    const text = condition.replace(/defined\s*\(?\s*(\w+)\s*\)?/g, (_, name) => Number(macros.has(name)));
    const numbers = expanded(tokensOf(text), macros).map((token) => isWord(token) ? '0' : token).join(' ');
    if (!/^[\d\s()<>=!&|+*-]*$/.test(numbers)) throw new Error(`#if ${condition}: the condition is not understood`);
    return Boolean(Function(`return ${numbers}`)());
}

// The lines that the preprocessor keeps, with the macros expanded, as tokens.
function preprocessed(text) {
    const macros = new Map(), open = [], kept = []; // open: for each #if, whether its lines are kept and whether a branch was
    const bare = text.replace(/\\\n/g, ' ').replace(/\/\/.*|\/\*[^]*?\*\//g, ' ');
    for (const line of bare.split('\n')) {
        const [, name, rest] = /^\s*#\s*(\w+)\s*(.*)$/.exec(line) ?? [], keeps = open.every(({on}) => on);
        if (name === 'if' || name === 'ifdef' || name === 'ifndef') {
            const on = keeps && (name === 'if' ? holds(rest, macros) : macros.has(rest.trim().split(/\s/)[0]) === (name === 'ifdef'));
            open.push({on, done: on || !keeps});
        } else if (name === 'elif' || name === 'else') {
            const one = open.at(-1);
            one.on = !one.done && (name === 'else' || holds(rest, macros));
            one.done ||= one.on;
        } else if (name === 'endif') open.pop();
        else if (keeps && name === 'define') {
            const [, word, call, value] = /^(\w+)(\(?)(.*)$/.exec(rest);
            if (call) throw new Error(`#define ${rest}: macros with parameters are not understood`);
            macros.set(word, tokensOf(value));
        } else if (keeps && name === 'undef') macros.delete(rest.trim());
        else if (keeps && name) throw new Error(`${line}: this directive is not understood`);
        else if (keeps) kept.push(...expanded(tokensOf(line), macros));
    }
    return kept;
}

// ---- Declarations ----

// The declarations of a text: [{names, tokens}], where names are what a declaration declares. A list of constants or
// variables becomes one declaration for each.
function declarationsOf(tokens) {
    const all = [];
    for (let from = 0, i = 0, depth = 0; i < tokens.length; i++) {
        depth += '{(['.includes(tokens[i]) - '})]'.includes(tokens[i]);
        const body = tokens[i] === '}' && depth === 0 && tokens[from] !== 'struct';
        if (depth > 0 || (tokens[i] !== ';' && !body)) continue;
        all.push(...partsOf(tokens.slice(from, i + 1)));
        from = i + 1;
    }
    return all;
}

function partsOf(tokens) {
    const at = tokens.findIndex((token) => '=(,;{['.includes(token));
    if (tokens[0] === ';') return [];
    if (tokens[0] === 'precision') return [];
    if (tokens[0] === 'struct' || tokens[at] === '(') return [{names: [tokens[tokens[0] === 'struct' ? 1 : at - 1]], tokens}];
    const parts = [[]], before = tokens.slice(0, at - 1);
    let depth = 0;
    for (const token of tokens.slice(at - 1, -1)) {
        depth += '{(['.includes(token) - '})]'.includes(token);
        if (token === ',' && depth === 0) parts.push([]);
        else parts.at(-1).push(token);
    }
    return parts.map((part) => ({names: [part[0]], tokens: [...before, ...part, ';']}));
}

// The declarations that mainImage needs, and all that they need.
function needed(declarations, roots) {
    const wanted = new Set(roots);
    for (const name of wanted) { // grows while it is read
        for (const {names, tokens} of declarations) if (names.includes(name)) for (const token of tokens) if (isWord(token)) wanted.add(token);
    }
    return declarations.filter(({names}) => names.some((name) => wanted.has(name)));
}

// Remove the prototype of a function that is defined before its first use, or not used at all.
function withoutPrototypes(declarations) {
    const isCall = ({tokens}) => tokens.at(-1) === ';' && tokens.includes('(') && !tokens.includes('=') && !['struct', 'const', 'uniform'].includes(tokens[0]);
    return declarations.filter((one, i) => {
        if (!isCall(one)) return true;
        const [name] = one.names, defined = declarations.findIndex((other) => other !== one && other.names[0] === name && other.tokens.at(-1) === '}');
        return declarations.slice(i + 1, defined).some(({tokens, names}) => names[0] !== name && tokens.includes(name));
    });
}

// ---- Text ----

const shortNumber = (token) => /^(?:\d+\.\d*|\.\d+)$/.test(token) ? token.replace(/(\.\d*?)0+$/, '$1').replace(/^0+(?=\.\d)/, '') : token;

function joined(tokens) {
    let text = '';
    for (const token of tokens.map(shortNumber)) {
        const last = text.at(-1) ?? '';
        text += (/\w/.test(last) && /^[\w.]/.test(token) && !(/[A-Za-z_)]/.test(last) && token === '.')) || (/[-+]/.test(last) && last === token[0]) ? ` ${token}` : token;
    }
    return text;
}

// Reduce a shader. Returns its text, and the names that it still declares.
//   text   what --print-shader=page printed
//   roots  the functions that the page calls; all that they do not use is removed
export function shrink(text, roots) {
    const found = withoutPrototypes(needed(declarationsOf(preprocessed(text)), roots));
    return {shader: joined(found.flatMap(({tokens}) => tokens)), names: new Set(found.flatMap(({names}) => names))};
}
