-- pages.lua - functions for the pages of docs/ that the book (book.lua) and the site (docs/web/filter.lua) share.

local pages = {}

-- The target of a link in a page: its kind, its file and its anchor ('' for none). The kind is 'outside'; 'here', the
-- same page; 'page', a page of docs/; or 'file', a file of the project, whose path is relative to the project's root.
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

-- The picture of a paragraph that contains nothing else; its alternative text becomes the caption.
function pages.figure(paragraph)
    local image = #paragraph.content == 1 and paragraph.content[1]
    if image and image.t == 'Image' then
        image.title = 'fig:' .. image.title
        return image
    end
end

-- Is this a diagram in Mermaid? It is only for GitHub; the table before it contains the same information.
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

return pages
