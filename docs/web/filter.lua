-- filter.lua - prepares a page of docs/ for site.mjs: links between pages, figures with captions, listings with the
-- names of their files, and the language of French text. site.mjs processes the data-… attributes.

local pages = dofile('.make/pages.lua')

-- The front page of the site replaces the project's README. docs/README.md, on how to read the course, becomes
-- reading.html.
local function address(file)
    return (file:gsub('^README%.md$', 'reading.md'):gsub('%.md$', '.html'))
end

local function link(element)
    local kind, file, id = pages.target(element.target)
    if kind == 'page' then
        element.target = address(file) .. (id ~= '' and '#' .. id or '')
    elseif file == 'README.md' then
        element.target = 'index.html'
    elseif kind == 'file' then
        element.target = 'source:' .. file
    elseif element.target:match('^https?:') and pandoc.utils.stringify(element) ~= element.target then
        element.classes:insert('elsewhere') -- the printed page shows the address of this link
    end
    return element
end

local function block(element)
    return pages.mermaid(element) and {} or nil
end

-- A French term follows its English term in brackets: (*distance signée*). Emphasised text without an opening bracket
-- before it is English.
local function french(inlines)
    for i = 2, #inlines do
        local before, here = inlines[i - 1], inlines[i]
        if here.t == 'Emph' and before.t == 'Str' and before.text:match('%($') then
            inlines[i] = pandoc.Span({here}, pandoc.Attr('', {}, {lang = 'fr'}))
        end
    end
    return inlines
end

local function word(element)
    return pandoc.Str(pages.minus(element.text))
end

local function raw(element)
    return element.format:match('html') and element.text:match('^<!%-%-') and {} or nil
end

-- Name each listing after the marker above it, and mark the French summary and its heading as French.
local function neighbours(blocks)
    for i = 1, #blocks - 1 do
        local here, after = blocks[i], blocks[i + 1]
        local file, name
        if here.t == 'RawBlock' then
            file, name = pages.marker(here.text)
        end
        if file and after.t == 'CodeBlock' then
            after.attributes.file, after.attributes.symbol = file, name
        elseif here.t == 'Header' and after.t == 'BlockQuote' and pandoc.utils.stringify(here) :match("^L.*essentiel$") then
            here.attributes.lang = 'fr'
            blocks[i + 1] = pandoc.Div(after.content, pandoc.Attr('', {'essential'}, {lang = 'fr'}))
        end
    end
    return blocks
end

function Pandoc(document)
    local blocks = pandoc.walk_block(pandoc.Div(neighbours(pages.captioned(document.blocks))), {
        Link = link, Para = pages.figure, CodeBlock = block, RawBlock = raw, RawInline = raw, Inlines = french, Str = word,
    }).content
    return pandoc.Pandoc(blocks, pandoc.Meta({}))
end
