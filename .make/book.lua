-- book.lua - turns a page of docs/ into a chapter of the book: links between pages become links inside the book, a
-- picture that is a paragraph by itself becomes a numbered figure, folds (<details>) move to the end of the chapter,
-- and comments are removed. Metadata: page, the name of the file, such as 03_shadows.md.

local pages = dofile('.make/pages.lua')
local page = 'page'

local function anchor(file, id)
    return (file:gsub('%.md$', '') .. (id ~= '' and '-' .. id or '')):lower()
end

function Meta(meta)
    page = pandoc.utils.stringify(meta.page)
end

local first, headings = true, {}

local function header(element)
    element.identifier = first and anchor(page, '') or anchor(page, element.identifier)
    first = false
    return element
end

local function link(element)
    local kind, file, id = pages.target(element.target)
    if kind == 'file' or (kind == 'here' and not headings[id]) then
        return element.content -- the text contains the file's name, or lights a point of a figure of the site
    elseif kind ~= 'outside' then
        element.target = '#' .. anchor(kind == 'here' and page or file, id)
    end
    return element
end

local function picture(element)
    element.attributes.width = element.attributes.width or '95%'
    return element
end

local function paragraph(element)
    local figure = pages.figure(element)
    return figure and pandoc.walk_block(figure, {Image = function(image)
        image.attributes.width = '88%'
        return image
    end})
end

-- A displayed formula that is wider than the page is scaled down.
local function formula(element)
    if element.mathtype == 'DisplayMath' then
        return pandoc.RawInline('latex', '\\[\\fitted{' .. element.text .. '}\\]')
    end
end

-- The length of a cell's text, or 60 if the cell has a picture.
local function width_of(cell)
    local pictures = false
    pandoc.walk_block(pandoc.Div(cell.contents), {Image = function(image)
        pictures = true
    end})
    return pictures and 60 or #pandoc.utils.stringify(pandoc.Div(cell.contents))
end

-- The length of the longest word in a cell, which cannot be broken, but at most 24. Code is left out because it can be
-- broken, and formulas because the length of their source says little about their width.
local function word_of(cell)
    local most = 0
    local prose = pandoc.walk_block(pandoc.Div(cell.contents), {
        Code = function() return {} end, Math = function() return {} end, RawInline = function() return {} end,
    })
    for word in pandoc.utils.stringify(prose):gmatch('%S+') do
        most = math.max(most, #word)
    end
    return math.min(most, 24)
end

local function table_widths(element)
    local longest, word, total, words = {}, {}, 0, 0
    local function look(rows)
        for _, row in ipairs(rows) do
            for i, cell in ipairs(row.cells) do
                longest[i] = math.max(longest[i] or 13, width_of(cell))
                word[i] = math.max(word[i] or 4, word_of(cell))
            end
        end
    end
    look(element.head.rows)
    for _, body in ipairs(element.bodies) do
        look(body.body)
    end
    for i = 1, #longest do
        total = total + longest[i]
    end
    if total < 70 then
        return nil
    end
    total = 0
    for i, longest_here in ipairs(longest) do
        longest[i] = math.min(longest_here, 90)
        total = total + longest[i]
        words = words + word[i]
    end
    -- A line has at least 84 characters. Each column has room for its longest word, and the columns share the rest of
    -- the line in proportion to their longest cells.
    local line = math.max(84, 1.1 * words)
    for i, spec in ipairs(element.colspecs) do
        element.colspecs[i] = {spec[1], word[i] / line + (1 - words / line) * longest[i] / total}
    end
    return pandoc.walk_block(element, {Image = function(image)
        image.attributes.width = string.format('%d%%', math.floor(92 / #longest)) -- an equal share of the page's width
        return image
    end})
end

local function raw(element)
    if element.format:match('html') then
        return {}
    end
end

local function block(element)
    return pages.mermaid(element) and {} or nil
end

-- ---- Folds ----

-- The name of a fold's owner: an exercise ('Exercise 3'), an experiment ('Experiment 3'), or otherwise the section.
local function owner(title, number)
    local kind = number and ({Experiments = 'Experiment', Exercises = 'Exercise'})[title]
    return kind and kind .. ' ' .. number or title
end

local function latex(text)
    return pandoc.RawInline('latex', text)
end

-- The blocks of a page with each fold replaced by a reference, and the folds at the end. The hints come first, so that
-- no hint is beside a solution.
local function unfolded(blocks)
    local kept, folds, order = {}, {Answer = {}, Hint = {}, Solution = {}}, {'Hint', 'Answer', 'Solution'}
    local title, number, into, count, reference = '', nil, nil, 0, nil
    for _, element in ipairs(blocks) do
        local html = element.t == 'RawBlock' and element.text or ''
        local kind = pages.fold(html)
        if kind and folds[kind] then
            count = count + 1
            local label = anchor(page, 'fold-' .. count)
            reference = reference or pandoc.Para({})
            if #reference.content == 0 then
                table.insert(kept, reference)
            else
                table.insert(reference.content, pandoc.Space())
            end
            table.insert(reference.content, pandoc.Emph({pandoc.Str(kind .. ':')}))
            table.insert(reference.content, latex(' page~\\pageref{' .. label .. '}.'))
            into = folds[kind]
            table.insert(into, pandoc.Para({latex('\\phantomsection\\label{' .. label .. '}'),
                pandoc.Strong(pandoc.Str(owner(title, number) .. '.')), latex('\\nopagebreak')}))
        elseif html:match('^</details>') then
            into = nil
        elseif into then
            table.insert(into, element)
        else
            reference = nil
            if element.t == 'Header' and element.level <= 2 then
                title, number = pandoc.utils.stringify(element.content), nil
            elseif element.t == 'Para' and element.content[1].t == 'Strong' then
                number = pandoc.utils.stringify(element.content[1]):match('^(%d+)%.') or number
            end
            table.insert(kept, element)
        end
    end
    if count > 0 then
        table.insert(kept, pandoc.Header(2, {pandoc.Str('Hints, answers and solutions')}, pandoc.Attr('folds')))
    end
    for _, kind in ipairs(order) do
        if #folds[kind] > 0 then
            table.insert(kept, pandoc.Header(3, {pandoc.Str(kind .. 's')}, pandoc.Attr('folds-' .. kind)))
        end
        for _, element in ipairs(folds[kind]) do
            table.insert(kept, element)
        end
    end
    return kept
end

function Pandoc(document)
    pandoc.walk_block(pandoc.Div(document.blocks), {Header = function(element)
        headings[element.identifier] = true
    end})
    local blocks = pandoc.walk_block(pandoc.Div(unfolded(pages.captioned(document.blocks))), {
        Header = header, Link = link, Para = paragraph, Image = picture, RawBlock = raw, RawInline = raw, Str = pages.str, Table = table_widths,
        Code = pages.code, CodeBlock = block, Math = formula,
    }).content
    return pandoc.Pandoc(blocks, pandoc.Meta({}))
end
