// source.c - tests how a shader's text is read: each include is replaced by its file, every line is
// traced back to its file, and a file that cannot be used is refused with one clear line.
#include "lib/test.h"

#include <unistd.h>

#include "shader/read.h"
#include "lib/scratch.h"
#include "lib/system.h"

// ---- A separate project for each test ----

static int set_up(void **state)
{
    scratch_setup(state);
    scratch_write("root/shaders/leaf.glsl", "float leaf();\n");
    scratch_write("root/shaders/twig.glsl", "// twig\n#include \"leaf.glsl\"\nfloat twig();\n");
    return 0;
}

// Read a text as root/chapters/main.frag. Fails the test if the text is refused or anything is
// reported.
static struct shader_source read_text(const char *text)
{
    struct shader_source source;
    const char *path = scratch_write("root/chapters/main.frag", text);
    capture_begin();
    bool done = shader_read(&source, path, scratch_path("root"));
    const char *said = capture_end();
    if (!done || said[0] != '\0')
        fail_msg("%s: %s", text, said);
    return source;
}

static void assert_text(const char *text, const char *expected)
{
    struct shader_source source = read_text(text);
    assert_string_equal(source.text, expected);
    shader_free(&source);
}

// Check that a file is refused with a single line that contains each of the words. NULL ends the
// words.
static void assert_file_refused(const char *path, const char *const words[])
{
    struct shader_source source;
    capture_begin();
    bool done = shader_read(&source, path, scratch_path("root"));
    const char *said = capture_end();
    assert_false(done);
    assert_null(source.text);
    for (int i = 0; words[i] != NULL; i++)
        if (line_count(said) != 1 || strstr(said, words[i]) == NULL)
            fail_msg("expected one line with '%s', not: %s", words[i], said);
}

#define assert_path_refused(path, ...)                                                             \
    assert_file_refused(path, (const char *const[]){__VA_ARGS__, NULL})
#define assert_refused(text, ...)                                                                  \
    assert_path_refused(scratch_write("root/chapters/main.frag", text), __VA_ARGS__)

// ---- Includes ----

#define IN_PROJECT(name) TEST_WITH(name, set_up, scratch_teardown)

IN_PROJECT(test_an_include_is_replaced_by_its_file)
{
    assert_text("a\n#include \"leaf.glsl\"\nb\n",
                "a\n// #include \"leaf.glsl\"\nfloat leaf();\nb\n");
    assert_text("  #  include\t\"leaf.glsl\"  // why\n",
                "//   #  include\t\"leaf.glsl\"  // why\nfloat leaf();\n");
    assert_text("#include\"leaf.glsl\"", "// #include\"leaf.glsl\"\nfloat leaf();\n");
}

IN_PROJECT(test_a_file_is_included_once)
{
    assert_text(
        "#include \"leaf.glsl\"\n#include \"twig.glsl\"\n#include \"../shaders/leaf.glsl\"\nx\n",
        "// #include \"leaf.glsl\"\nfloat leaf();\n"
        "// #include \"twig.glsl\"\n// twig\n// #include \"leaf.glsl\"\nfloat twig();\n"
        "// #include \"../shaders/leaf.glsl\"\nx\n");
}

IN_PROJECT(test_every_line_is_traced)
{
    struct shader_source source = read_text("one\n#include \"twig.glsl\"\n\nfour\n");
    const struct shader_line expected[] = {{0, 1}, {0, 2}, {1, 1}, {1, 2},
                                           {2, 1}, {1, 3}, {0, 3}, {0, 4}};
    assert_int_equal(source.line_count, 8);
    assert_memory_equal(source.lines, expected, sizeof expected);
    assert_int_equal(line_count(source.text), 8);
    assert_int_equal(source.file_count, 3);
    assert_string_equal(source.files[0], scratch_path("root/chapters/main.frag"));
    assert_string_equal(source.files[1], "shaders/twig.glsl");
    assert_string_equal(source.files[2], "shaders/leaf.glsl");
    assert_string_equal(source.paths[2], scratch_path("root/shaders/leaf.glsl"));
    shader_free(&source);
}

IN_PROJECT(test_the_including_file_s_folder_comes_before_shaders)
{
    scratch_write("root/chapters/leaf.glsl", "float mine();\n");
    assert_text("#include \"leaf.glsl\"\n", "// #include \"leaf.glsl\"\nfloat mine();\n");
    scratch_write("root/shaders/deep/a.glsl", "#include \"b.glsl\"\n");
    scratch_write("root/shaders/deep/b.glsl", "b\n");
    assert_text("#include \"deep/a.glsl\"\n",
                "// #include \"deep/a.glsl\"\n// #include \"b.glsl\"\nb\n");
}

IN_PROJECT(test_a_shader_outside_the_project_can_include_files)
{
    struct shader_source source;
    scratch_write("own/near.glsl", "near\n");
    scratch_write("own/deep/down.glsl", "#include \"../near.glsl\"\n");
    const char *path =
        scratch_write("own/my.frag", "#include \"deep/down.glsl\"\n#include \"leaf.glsl\"\n");
    assert_true(shader_read(&source, path, scratch_path("root")));
    assert_int_equal(source.file_count, 4);
    assert_string_equal(source.files[2], scratch_path("own/near.glsl"));
    assert_string_equal(source.files[3], "shaders/leaf.glsl");
    shader_free(&source);
}

// A file in any folder can include a chapter, but a file of the same name in the including file's
// folder or in shaders/ takes precedence.
IN_PROJECT(test_chapters_come_last)
{
    struct shader_source source;
    scratch_write("root/chapters/01_scene.frag", "scene\n");
    scratch_write("root/chapters/leaf.glsl", "not this leaf\n");
    const char *path =
        scratch_write("own/my.frag", "#include \"01_scene.frag\"\n#include \"leaf.glsl\"\n");
    assert_true(shader_read(&source, path, scratch_path("root")));
    assert_int_equal(source.file_count, 3);
    assert_string_equal(source.files[1], "chapters/01_scene.frag");
    assert_string_equal(source.files[2], "shaders/leaf.glsl");
    shader_free(&source);
    scratch_write("own/01_scene.frag", "mine\n");
    assert_true(shader_read(&source, path, scratch_path("root")));
    assert_string_equal(source.paths[1], scratch_path("own/01_scene.frag"));
    shader_free(&source);
    scratch_write("root/chapters/deep/my.frag", "#include \"01_scene.frag\"\n");
    assert_true(
        shader_read(&source, scratch_path("root/chapters/deep/my.frag"), scratch_path("root")));
    assert_string_equal(source.files[1], "chapters/01_scene.frag");
    shader_free(&source);
}

IN_PROJECT(test_a_file_keeps_its_name_as_given)
{
    struct shader_source source;
    char before[4096];
    assert_non_null(getcwd(before, sizeof before));
    scratch_write("own/near.glsl", "near\n");
    scratch_write("own/my.frag", "#include \"near.glsl\"\n");
    assert_int_equal(chdir(scratch_path("own")), 0);
    bool bare = shader_read(&source, "my.frag", scratch_path("root"));
    assert_int_equal(chdir(before), 0);
    assert_true(bare);
    assert_string_equal(source.files[0], "my.frag");
    assert_string_equal(source.files[1], "near.glsl");
    shader_free(&source);
}

IN_PROJECT(test_comments_include_nothing)
{
    const char *text =
        "// #include \"none.glsl\"\n/* #include \"none.glsl\"\n#include \"none.glsl\"\n*/\n"
        "// goes on \\\n#include \"none.glsl\"\n#includes\nx / y // */\n";
    assert_text(text, text);
}

IN_PROJECT(test_nested_includes_have_a_limit)
{
    char name[64], text[64];
    for (int i = 0; i < 70; i++) {
        snprintf(name, sizeof name, "root/shaders/n%d.glsl", i);
        snprintf(text, sizeof text, "#include \"n%d.glsl\"\n", i + 1);
        scratch_write(name, text);
    }
    assert_refused("#include \"n0.glsl\"\n", "shaders/n62.glsl:1: ", "64 nested includes");
    scratch_write("root/shaders/n63.glsl", "end\n");
    assert_refused("#include \"n0.glsl\"\n", "shaders/n62.glsl:1: ", "64 nested includes");
    scratch_write("root/shaders/n62.glsl", "end\n");
    struct shader_source source = read_text("#include \"n0.glsl\"\n");
    assert_int_equal(source.file_count, 64);
    assert_int_equal(source.line_count, 64);
    shader_free(&source);
}

IN_PROJECT(test_a_missing_include_is_refused)
{
    assert_refused("\n\n#include \"foo.glsl\"\n", "main.frag:3: #include \"foo.glsl\": ",
                   "no such file beside main.frag, in shaders/ or in chapters/");
    scratch_write("root/shaders/broken.glsl", "\n#include \"gone.glsl\"\n");
    assert_refused("#include \"broken.glsl\"\n", "shaders/broken.glsl:2: #include \"gone.glsl\": ");
}

static void note(void *to, const char *path)
{
    size_t size = strlen(to);
    snprintf((char *)to + size, 4096 - size, "%s\n", path);
}

// A window must watch each file that is read, and all possible locations of a missing file.
IN_PROJECT(test_every_file_is_visited)
{
    struct shader_source source;
    char visited[4096] = "";
    scratch_write("root/shaders/broken.glsl", "#include \"leaf.glsl\"\n#include \"gone.glsl\"\n");
    const char *path = scratch_write("root/chapters/main.frag", "#include \"broken.glsl\"\n");
    capture_begin();
    const struct shader_request request = {.visit = note, .to = visited};
    assert_false(shader_read_asked(&source, path, scratch_path("root"), &request));
    capture_end();
    static const char *const files[] = {"root/chapters/main.frag", "root/shaders/broken.glsl",
                                        "root/shaders/leaf.glsl", "root/shaders/gone.glsl",
                                        "root/chapters/gone.glsl"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (strstr(visited, scratch_path(files[i])) == NULL)
            fail_msg("%s is missing in: %s", files[i], visited);
    assert_null(source.text);
}

IN_PROJECT(test_cycles_of_includes_are_refused)
{
    assert_refused("x\n#include \"main.frag\"\n", "main.frag:2: ", "includes itself",
                   "main.frag -> ");
    scratch_write("root/shaders/a.glsl", "#include \"b.glsl\"\n");
    scratch_write("root/shaders/b.glsl", "\n#include \"a.glsl\"\n");
    assert_refused("#include \"a.glsl\"\n",
                   "shaders/b.glsl:2: ", "shaders/a.glsl -> shaders/b.glsl -> shaders/a.glsl");
}

IN_PROJECT(test_paths_out_of_the_project_are_refused)
{
    scratch_write("secret.glsl", "secret\n");
    scratch_write("rootless/secret.glsl", "secret\n");
    assert_refused("#include \"../../secret.glsl\"\n", "main.frag:1: ", "outside the project");
    assert_refused("#include \"../../rootless/secret.glsl\"\n",
                   "main.frag:1: ", "outside the project");
    // This path goes up to the root of the disk and down again, without a drive letter.
    const char *secret = scratch_path("secret.glsl");
    char text[PLATFORM_PATH];
    snprintf(text, sizeof text, "#include \"../../../../../../../../../..%s\"\n",
             strchr(secret, '/'));
    assert_refused(text, "main.frag:1: ", "outside the project");
    snprintf(text, sizeof text, "#include \"%s\"\n", secret);
    assert_refused(text, "main.frag:1: ", "absolute");
    assert_refused("#include \"c:leaf.glsl\"\n", "main.frag:1: ", "absolute");
}

// A file in the request's folder may be read, under a name below that of the folder, but none
// beside that folder.
IN_PROJECT(test_the_request_names_another_folder)
{
    static const char first[] = "#include \"../lib/fill.glsl\"\n#include \"lib/fill.glsl\"\n"
                                "#include \"lib/more.glsl\"\n";
    static const struct {
        const char *text, *folder, *words;
    } refused[] = {{first, NULL,
                    "one.frag:1: #include \"../lib/fill.glsl\": lies outside the project and the "
                    "shader's own folder: give --include DIR, a folder that contains it"},
                   {first + 27, NULL,
                    "no such file beside one.frag, in shaders/ or in chapters/: give --include"},
                   {first, "deck/lib",
                    "one.frag:2: #include \"lib/fill.glsl\": no such file beside one.frag, "
                    "in --include"},
                   {first, "gone", "/gone: cannot be read"},
                   {"#include \"../../deck.glsl\"\n", "deck", "deck.glsl\": lies outside"}};
    struct shader_source source;
    scratch_write("deck/lib/fill.glsl", "float fill();\n");
    scratch_write("deck/lib/more.glsl", "#include \"fill.glsl\"\nfloat more();\n");
    scratch_write("deck.glsl", "secret\n");
    for (size_t i = 0; i <= sizeof refused / sizeof *refused; i++) {
        bool all = i == sizeof refused / sizeof *refused;
        const char *path = scratch_write("deck/cards/one.frag", all ? first : refused[i].text),
                   *folder = all ? "deck" : refused[i].folder;
        const struct shader_request request = {.include =
                                                   folder != NULL ? scratch_path(folder) : NULL};
        capture_begin();
        bool done = shader_expand(&source, path, scratch_path("root"), &request);
        const char *said = capture_end();
        if (all)
            assert_true(done);
        else if (done || line_count(said) != 1 || strstr(said, refused[i].words) == NULL)
            fail_msg("expected one line with '%s', not: %s", refused[i].words, said);
    }
    assert_string_equal(source.text, "// #include \"../lib/fill.glsl\"\nfloat fill();\n"
                                     "// #include \"lib/fill.glsl\"\n"
                                     "// #include \"lib/more.glsl\"\n"
                                     "// #include \"fill.glsl\"\nfloat more();\n");
    assert_int_equal(source.file_count, 3);
    assert_string_equal(source.files[1], scratch_path("deck/lib/fill.glsl"));
    shader_free(&source);
}

IN_PROJECT(test_links_out_of_the_project_are_refused)
{
    scratch_write("secret.glsl", "secret\n");
    if (!system_make_link("../../secret.glsl", scratch_path("root/shaders/link.glsl")))
        skip();
    assert_refused("#include \"link.glsl\"\n", "main.frag:1: ", "outside the project");
    system_make_link("leaf.glsl", scratch_path("root/shaders/inner.glsl"));
    assert_text("#include \"inner.glsl\"\n#include \"leaf.glsl\"\n",
                "// #include \"inner.glsl\"\nfloat leaf();\n// #include \"leaf.glsl\"\n");
}

// On a system that distinguishes upper and lower case, a link provides the name in the other case.
IN_PROJECT(test_names_in_another_case_are_refused)
{
    assert_refused("#include \"Leaf.glsl\"\n", "main.frag:1: #include \"Leaf.glsl\": ");
    system_make_link("leaf.glsl", scratch_path("root/shaders/LEAF.glsl"));
    assert_refused("\n#include \"LEAF.glsl\"\n",
                   "main.frag:2: #include \"LEAF.glsl\": ", "the name on disk is leaf.glsl: ");
    scratch_write("root/shaders/deep/a.glsl", "a\n");
    system_make_link("deep", scratch_path("root/shaders/Deep"));
    assert_refused("#include \"../shaders/Deep/a.glsl\"\n", "is deep/a.glsl: ");
    assert_text("#include \"../shaders/deep/a.glsl\"\n",
                "// #include \"../shaders/deep/a.glsl\"\na\n");
    if (system_make_link("deep", scratch_path("root/shaders/Keep")))
        assert_text("#include \"Keep/a.glsl\"\n", "// #include \"Keep/a.glsl\"\na\n");
    assert_refused("#include \"deep\\a.glsl\"\n", "only on Windows: write /");
}

IN_PROJECT(test_malformed_includes_are_refused)
{
    const char *const lines[] = {"#include\n",
                                 "#include leaf.glsl\n",
                                 "#include \"leaf.glsl\n",
                                 "#include \"leaf.glsl\nx\"\n",
                                 "#include \"\"\n",
                                 "#include \"leaf.glsl\" x\n",
                                 "#include \"leaf.glsl\" /* on\n*/\n",
                                 "/*\n*/ #include \"leaf.glsl\"\n",
                                 "#include \"leaf.glsl\" // on \\\nx\n",
                                 "#include \\\n\"leaf.glsl\"\n"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        assert_refused(lines[i], "malformed include", i == 7 ? "main.frag:2: " : "main.frag:1: ");
    assert_refused("#include <leaf.glsl>\n", "#include <leaf.glsl>: a part of a library",
                   "main.frag:1: ");
    assert_refused("#include <leaf.glsl\n", "malformed include", "main.frag:1: ");
}

// ---- Files that are not shaders ----

IN_PROJECT(test_line_ends_and_byte_order_marks_are_tidied)
{
    scratch_write("root/shaders/leaf.glsl", "\xEF\xBB\xBFleaf\r\n\r\n");
    assert_text("\xEF\xBB\xBF"
                "a\r\nb\r\n#include \"leaf.glsl\"\r\nc",
                "a\nb\n// #include \"leaf.glsl\"\nleaf\n\nc\n");
    assert_text("a\rb\r", "a\nb\n");
    assert_text("a", "a\n");
    assert_text("a // \\", "a // \\\n\n");
}

IN_PROJECT(test_binary_and_empty_files_are_refused)
{
    const char *path = scratch_write_bytes("root/chapters/bin.frag", "a\0b\n", 4);
    assert_path_refused(path, "bin.frag: ", "zero byte");
    assert_path_refused(scratch_write_bytes("root/chapters/bin.frag", "a\n\0", 3), "zero byte");
    assert_refused("", "main.frag: empty");
    assert_refused(" \n\t\r\n", "main.frag: empty");
    assert_refused("\xEF\xBB\xBF\n", "main.frag: empty");
    scratch_write("root/shaders/none.glsl", "\n");
    assert_refused("#include \"none.glsl\"\n", "main.frag:1: #include \"none.glsl\": empty");
}

static char *long_text(size_t size)
{
    char *text = malloc(size + 1);
    assert_non_null(text);
    for (size_t i = 0; i < size; i++)
        text[i] = i % 64 == 63 ? '\n' : 'x';
    text[size] = '\0';
    return text;
}

IN_PROJECT(test_files_that_are_too_large_are_refused)
{
    char *text = long_text(1024 * 1024 + 1), name[64], all[1024] = "";
    assert_refused(text, "main.frag: ", "1 MiB");
    scratch_write("root/shaders/big.glsl", text);
    assert_refused("#include \"big.glsl\"\n", "main.frag:1: #include \"big.glsl\": ", "1 MiB");
    text[1024 * 1024] = '\0';
    struct shader_source source = read_text(text);
    assert_int_equal(source.line_count, 16384);
    shader_free(&source);
    for (int i = 0; i < 9; i++) {
        snprintf(name, sizeof name, "root/shaders/big%d.glsl", i);
        scratch_write(name, text);
        snprintf(all + strlen(all), sizeof all - strlen(all), "#include \"big%d.glsl\"\n", i);
    }
    assert_refused(all, "shaders/big7.glsl:", "8 MiB");
    free(text);
}

IN_PROJECT(test_special_files_are_refused)
{
    assert_path_refused(scratch_path("root/shaders"), "not a regular file");
    assert_path_refused(scratch_path("root/none.frag"), "none.frag: ", "No such file");
    assert_path_refused("/dev/zero", "/dev/zero: not a regular file");
    assert_path_refused("", "cannot be read");
    assert_refused("#include \".\"\n", "main.frag:1: ", "not a regular file");
    if (!system_make_pipe(scratch_path("root/shaders/fifo.glsl")))
        return;
    assert_path_refused(scratch_path("root/shaders/fifo.glsl"), "not a regular file");
    assert_refused("#include \"fifo.glsl\"\n", "main.frag:1: ", "not a regular file");
}

IN_PROJECT(test_an_open_comment_is_refused)
{
    assert_refused("a\n/* b\nc\n", "main.frag:2: ", "never closed");
    scratch_write("root/shaders/open.glsl", "/* x\n");
    assert_refused("#include \"open.glsl\"\n*/\n", "shaders/open.glsl:1: ", "never closed");
}

// ---- Directives ----

IN_PROJECT(test_line_directives_are_disabled_and_a_late_version_is_refused)
{
    assert_text("x\n # line 100\ny\n", "x\n//  # line 100\ny\n");
    assert_refused("x\n#version 330 core\n", "main.frag:2: #version must come first");
    assert_refused("#include \"leaf.glsl\"\n#version 330 core\n", "main.frag:2: #version must");
    scratch_write("root/shaders/leaf.glsl", "// x\n#version 330\n");
    assert_refused("#include \"leaf.glsl\"\n", "shaders/leaf.glsl:2: #version");
}

// Neither a shader that is read nor one that is refused leaves a file open.
IN_PROJECT(test_no_file_stays_open)
{
    scratch_write("root/chapters/broken.frag", "#include \"nothing.glsl\"\n");
    scratch_write("root/chapters/empty.frag", "");
    int before = system_open_files();
    for (int i = 0; i < 50; i++) {
        struct shader_source source = read_text("#include \"twig.glsl\"\nx\n");
        shader_free(&source);
        assert_path_refused(scratch_path("root/chapters/broken.frag"), "nothing.glsl");
        assert_path_refused(scratch_path("root/chapters/empty.frag"), "empty");
    }
    assert_int_equal(system_open_files(), before);
}

TESTS(NULL, NULL)
