-- pages.lua - what the book (book.lua) and the site (docs/web/filter.lua) both know about a page of docs/.

local pages = {}

-- Where a link of a page leads: 'outside'; 'here', to a place of the same page; 'page', to one of docs/; 'file',
-- to a file of the project. Then its file and its place, '' for none; a file of the project counts from the top.
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

-- The picture of a paragraph that holds nothing else: its words become the caption.
function pages.figure(paragraph)
    local image = #paragraph.content == 1 and paragraph.content[1]
    if image and image.t == 'Image' then
        image.title = 'fig:' .. image.title
        return image
    end
end

-- A diagram in Mermaid is for GitHub's screen; the table before it says the same.
function pages.mermaid(block)
    return block.classes:includes('mermaid')
end

-- What a marker of listings.sh says of the block below it: the file and the name.
function pages.marker(html)
    return html:match('^<!%-%- code: (%S+) (%S+).*%-%->')
end

-- The kind of a fold that a raw block opens: Answer, Hint or Solution.
function pages.fold(html)
    return html:match('^<details><summary>(%a+)</summary>')
end

return pages
