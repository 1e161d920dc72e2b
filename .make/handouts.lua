-- handouts.lua - turns docs/teaching.md into handouts: two pages for each lab or, if the metadata contain `answers`,
-- one page with the answers to each lab. A lab is a section '### Lab 3: chapters 02 and 03, ...' with a list, whose
-- items begin with *Predict.*, *Show.*, *Step by step.*, *Work.* and *Exit question.*; the answer to a question follows
-- it in brackets.

local pages = dofile('.make/pages.lua')
local answers = false

local function latex(text)
    return pandoc.RawBlock('latex', text)
end

local function read(path)
    local file = io.open(path)
    local text = file and file:read('a') or ''
    if file then file:close() end
    return text
end

-- A heading that is never alone at the end of a page.
local function heading(size, inlines)
    local begin = pandoc.RawInline('latex', '\\heading{' .. size .. '}{')
    return pandoc.Para({begin, pandoc.Span(inlines), pandoc.RawInline('latex', '}')})
end

-- ---- Questions and answers ----

-- The index of the inline that closes the answer's bracket opened at inline i, or nil if no answer begins there. An
-- answer follows the end of a sentence.
local function answer_at(inlines, i)
    local inline, before = inlines[i], inlines[i - 1]
    if inline.t ~= 'Str' or inline.text:sub(1, 1) ~= '(' then return nil end
    if before and (before.t == 'Space' or before.t == 'SoftBreak') then before = inlines[i - 2] end
    if not before or not pandoc.utils.stringify(before):match('[?.]%)?$') then return nil end
    local depth = 0
    for k = i, #inlines do
        local text = (inlines[k].t == 'Code' or inlines[k].t == 'Math') and '' or pandoc.utils.stringify(inlines[k])
        for bracket in text:gmatch('[()]') do
            depth = depth + (bracket == '(' and 1 or -1)
        end
        if depth == 0 then return k end
    end
end

-- The inlines of a part. In a handout, each answer is replaced with lines to write on; in the sheets of answers, it is
-- set in italics.
local function answered(inlines)
    local result, i, last = {}, 1, nil
    while i <= #inlines do
        last = answer_at(inlines, i)
        if not last then
            table.insert(result, inlines[i])
        elseif answers then
            table.insert(result, pandoc.Emph({table.unpack(inlines, i, last)}))
        else
            table.insert(result, pandoc.RawInline('latex', '\\writing{}\\writing{}'))
        end
        i = (last or i) + 1
    end
    if not last and not answers then
        table.insert(result, pandoc.RawInline('latex', '\\writing{}\\writing{}'))
    end
    return result
end

-- ---- Exercises and questions of a chapter ----

local function page_of(chapter)
    local names = pandoc.pipe('sh', {'-c', 'ls docs/' .. chapter .. '*.md'}, '')
    return names:match('%S+')
end

-- A row for each exercise of a page: number, level, title, and the name of its check.
local function exercises(page)
    local rows, section = {}, read(page):match('\n## Exercises\n(.*)') or ''
    for number, level, title, rest in section:gmatch('\n%*%*(%d+)%. %((%a+)%) ([^*]+)%*%*(.-)%f[\n%z]%f[\n%z]') do
        table.insert(rows, {number = number, level = level, title = title:gsub('%.$', ''):gsub('\n', ' ')})
    end
    for _, row in ipairs(rows) do
        row.check = section:match('EXERCISE=(%w+_' .. row.number .. ')%f[%W]')
    end
    return rows
end

local function exercise_table(chapters)
    local text = {'| | | exercise | check |', '|---|---|---------------|----------------|'}
    for _, chapter in ipairs(chapters) do
        for _, row in ipairs(exercises(page_of(chapter))) do
            local check = row.check and '`make check EXERCISE=' .. row.check .. ' FILE=my.' ..
                (chapter == 'engine' and 'c' or 'frag') .. '`' or ''
            table.insert(text, string.format('| %s %s | %s | %s | %s |', chapter == 'engine' and '' or chapter, row.number,
                row.level, row.title, check))
        end
    end
    return #text > 2 and pandoc.read(table.concat(text, '\n') .. '\n', 'gfm+tex_math_dollars').blocks or {}
end

-- The questions of docs/questions.txt on a chapter, each with its answers in order.
local function questions(chapter)
    local found, question = {}, nil
    for line in read('docs/questions.txt'):gmatch('[^\n]+') do
        local of, text = line:match('^## (%w+)%.%d+ (.*)')
        local mark, answer = line:match('^([+-]) (.*)')
        if of then
            question = of == chapter and {text = text, answers = {}} or nil
            table.insert(found, question)
        elseif mark and question then
            local why
            answer, why = (answer .. ' // '):match('^(.-) // (.-)%s*/*%s*$')
            table.insert(question.answers, {right = mark == '+', text = answer, why = why})
        end
    end
    return found
end

-- The blocks of at most four questions, which the chapters share equally.
local function question_blocks(chapters)
    local blocks = {}
    for _, chapter in ipairs(chapters) do
        local all = questions(chapter)
        for i = 1, math.min(#all, math.floor(4 / #chapters)) do
            local question = all[i]
            table.insert(blocks, pandoc.Para({pandoc.Strong(pandoc.Str(question.text))}))
            for _, answer in ipairs(question.answers) do
                local mark = not answers and '$\\square$' or answer.right and '$\\boxtimes$' or '$\\square$'
                local inlines = {pandoc.RawInline('latex', '\\hspace*{2mm}' .. mark .. '~~'), pandoc.Str(answer.text)}
                if answers and answer.why ~= '' then
                    table.insert(inlines, pandoc.Space())
                    table.insert(inlines, pandoc.Emph(pandoc.Str(answer.why)))
                end
                table.insert(blocks, pandoc.Para(inlines))
            end
        end
    end
    if #blocks > 0 then
        table.insert(blocks, 1, latex('{\\small\\setlength{\\parskip}{1mm}'))
        table.insert(blocks, latex('}'))
    end
    return blocks
end

-- ---- A lab ----

-- The parts of a lab's list by their names. Each part has the inlines after the name, then further blocks.
local function parts_of(list)
    local parts = {}
    for _, item in ipairs(list.content) do
        local first = item[1]
        local name = pandoc.utils.stringify(first.content[1]):gsub('%.$', '')
        parts[name] = {pandoc.Para({table.unpack(first.content, 3)}), table.unpack(item, 2)}
    end
    return parts
end

local function section(blocks, title, part, asks)
    if not part then return end
    table.insert(blocks, heading('large', {pandoc.Str(title)}))
    for i, block in ipairs(part) do
        table.insert(blocks, asks and i == 1 and pandoc.Para(answered(block.content)) or block)
    end
end

local function append(blocks, more)
    for _, block in ipairs(more) do
        table.insert(blocks, block)
    end
end

local function handout(title, list)
    local name = pandoc.utils.stringify(title)
    local blocks, parts, chapters, pictures = {}, parts_of(list), {}, {}
    for chapter in name:gsub('^[^:]*:', ''):gmatch('%f[%d]%d%d%f[%D]') do
        table.insert(chapters, chapter)
    end
    if #chapters == 0 then chapters = {'engine'} end
    table.insert(blocks, latex('\\newpage'))
    table.insert(blocks, heading('Large', title))
    if answers then
        section(blocks, 'Predict', parts['Predict'], true)
        section(blocks, 'Step by step', parts['Step by step'], true)
        section(blocks, 'Exit question', parts['Exit question'], true)
        append(blocks, question_blocks(chapters))
        return blocks
    end
    table.insert(blocks, latex('\\noindent Names: \\hrulefill\\par'))
    for i = 1, math.min(#chapters, 2) do
        local page = page_of(chapters[i]):match('docs/(.*)%.md')
        local picture = page == 'engine' and 'engine_5' or page
        table.insert(pictures, string.format('\\includegraphics[height=46mm]{tests/references/%s.png}', picture))
    end
    section(blocks, 'Predict: ten minutes, in pairs', parts['Predict'], true)
    table.insert(blocks, latex('\\par\\vfill\\noindent\\centerline{' .. table.concat(pictures, '\\hspace{3mm}') .. '}\\vfill'))
    section(blocks, 'Show: fifteen minutes', parts['Show'])
    section(blocks, 'Step by step', parts['Step by step'], true)
    table.insert(blocks, latex('\\writing{}\\writing{}\\newpage'))
    section(blocks, 'Work: eighty minutes', parts['Work'])
    append(blocks, exercise_table(chapters))
    table.insert(blocks, latex('\\vfill'))
    section(blocks, 'Exit question: one minute', parts['Exit question'], true)
    append(blocks, question_blocks(chapters))
    table.insert(blocks, latex('\\vfill'))
    return blocks
end

function Pandoc(document)
    answers = document.meta.answers and true or false
    local result, title, inside = {}, nil, false
    for _, block in ipairs(document.blocks) do
        if block.t == 'Header' and block.level <= 2 then
            inside = pandoc.utils.stringify(block):match('^The labs') ~= nil
        elseif inside and block.t == 'Header' then
            title = block.content
        elseif inside and block.t == 'BulletList' and title then
            append(result, handout(title, block))
            title = nil
        end
    end
    local blocks = pandoc.walk_block(pandoc.Div(result), {
        Link = function(link) return link.content end, Str = pages.str, Code = pages.code,
    }).content
    return pandoc.Pandoc(blocks, pandoc.Meta({}))
end
