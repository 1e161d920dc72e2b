-- pages.lua - functions for the pages of docs/ that the book (book.lua), the handouts (handouts.lua) and the site
-- (docs/web/filter.lua) share.

local pages = {}

-- The target of a link in a page: its kind, its file and its anchor ('' if there is none). The kind is 'outside' for a
-- URL, which is returned as the file; 'here' for the same page; 'page' for a page of docs/; or 'file' for a file of the
-- project, whose path is relative to the project's root.
function pages.target(target)
    if target:match('^%a+:') then
        return 'outside', target, ''
    elseif target:match('^#') then
        return 'here', '', target:sub(2)
    end
    local file, id = target:match('^([%w_]+%.md)#?(.*)$')
    if file then
        return 'page', file, id
    end
    file, id = target:match('^([^#]*)#?(.*)$')
    return 'file', file:match('^%.%./(.*)$') or 'docs/' .. file, id
end

-- The only inline of a paragraph if it has the given kind, or nil.
local function only(block, kind)
    local inline = block and block.t == 'Para' and #block.content == 1 and block.content[1]
    return inline and inline.t == kind and inline or nil
end

-- The figure with the picture of a paragraph that contains nothing else, or nil. Its caption is the alternative text,
-- unless pages.captioned has found another. Before version 3, pandoc had no figures, only pictures with such a title.
function pages.figure(paragraph)
    local image = only(paragraph, 'Image')
    if image and pandoc.Figure then
        return pandoc.Figure({pandoc.Plain({image})}, {long = {pandoc.Plain(image.caption)}})
    elseif image then
        image.title = 'fig:' .. image.title
        return pandoc.Para({image})
    end
end

-- The blocks of a page, in which each line of emphasised text below a picture has become the caption of the picture.
function pages.captioned(blocks)
    local kept = {}
    for _, block in ipairs(blocks) do
        local image, line = only(kept[#kept], 'Image'), only(block, 'Emph')
        if image and line then
            image.attributes.alt = pandoc.utils.stringify(image.caption)
            image.caption = line.content
            kept[#kept] = pandoc.Para({image})
        else
            table.insert(kept, block)
        end
    end
    return kept
end

-- True for a diagram in Mermaid, which is only for GitHub; the table before it contains the same information.
function pages.mermaid(block)
    return block.classes:includes('mermaid')
end

-- The file and the name in a marker of listings.sh, which describe the block below it.
function pages.marker(html)
    return html:match('^<!%-%- code: (%S+) (%S+).*%-%->')
end

-- The kind of a fold that a raw block opens: Answer, Hint or Solution.
function pages.fold(html)
    return html:match('^<details><summary>(%a+)</summary>')
end

-- The text of a word, in which the hyphen before a number, or before one of several, has become a minus sign.
function pages.minus(text)
    return (text:gsub('^([(%[]?)%-(%.?%d)', '%1−%2'):gsub('(%d,)%-(%.?%d)', '%1−%2'))
end

-- ---- For LaTeX ----

-- Characters that the font of the text lacks are set in another font.
function pages.str(element)
    local parts, plain = {}, ''
    for _, code in utf8.codes(pages.minus(element.text)) do
        local sign = utf8.char(code)
        if code >= 0x2070 and sign ~= '−' then
            if plain ~= '' then table.insert(parts, pandoc.Str(plain)) end
            plain = ''
            table.insert(parts, pandoc.RawInline('latex', '{\\symbolfont ' .. sign .. '}'))
        else
            plain = plain .. sign
        end
    end
    if plain ~= '' then table.insert(parts, pandoc.Str(plain)) end
    return parts
end

-- Inline code may break after punctuation and before a capital letter, so that long paths fit on the page.
local escapes = {
    ['\\'] = '\\textbackslash{}', ['{'] = '\\{', ['}'] = '\\}', ['$'] = '\\$', ['&'] = '\\&', ['#'] = '\\#',
    ['%'] = '\\%', ['_'] = '\\_', ['^'] = '\\textasciicircum{}', ['~'] = '\\textasciitilde{}',
    ["'"] = '\\textquotesingle{}', ['`'] = '\\textasciigrave{}',
}

function pages.code(element)
    if #element.text < 12 then
        return nil
    end
    local text = element.text:gsub('[\\{}$&#%%_^~\'`]', escapes)
    text = text:gsub('([/,=_(])', '%1\\allowbreak{}'):gsub('%-%-', '-\\/-')
    text = text:gsub('(%l)(%u)', '%1\\allowbreak{}%2')
    return pandoc.RawInline('latex', '\\texttt{' .. text .. '}')
end

return pages
