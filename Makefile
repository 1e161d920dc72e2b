# All commands of the project; `make help` lists them. GNU make 3.81 is enough.
# Chapters, modules and tests are found by their names, never listed.

# -O2 would take a quarter longer to compile and draw no faster, because the driver draws the pictures. Programs built
# with WINDOWS=1 are handed out, so they have no symbols for a debugger.
CFLAGS ?= -O1$(if $(WINDOWS),, -g)
OPTIONS =
CHAPTER =
FIGURE =
SUITE =
COUNT =
SEED =
EXERCISE =
NAME =
FILE =
FILES =
PICTURES =
FORCE =
LIST =
FRAMES =
FPS =
VIEW =
ROUNDS =
WRITE =
WEB =
ADDRESS =
WINDOWS =
STUDENT =
PORT = 8000
DURATION =
SECONDS =
PROGRAM =
SANITIZE =
FUZZER =
# The input and output of awk, sort and gcc must not depend on the user's language.
export LC_ALL = C
export CHAPTER FIGURE LIST NOTES SUITE COUNT SEED NAME EXERCISE EXERCISES CSV CSV_STYLE STUDENTS IDENTIFIER WEIGHTS FILE FILES PICTURES FORCE FRAMES FPS VIEW ROUNDS WRITE ADDRESS DURATION SECONDS PROGRAM
# Without this, `make run chapter=03` would open chapter 00 without a word.
SMALL := $(firstword $(filter chapter=% figure=% exercise=% suite=% view=% options=% name=% file=%,$(MAKEOVERRIDES)))
ifneq ($(SMALL),)
$(error $(SMALL): write the name in capitals, as in make run CHAPTER=03)
endif

# Recursive makes run in parallel, unless the caller has chosen the number of jobs.
CPUS := $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
PARALLEL = $(if $(filter -j% --jobserver%,$(MAKEFLAGS)),,-j$(CPUS))
# A recipe that uses AGAIN needs a '+' to pass on the caller's jobs: make itself looks only for the word MAKE.
AGAIN = $(MAKE) --no-print-directory $(if $(V),,-s) $(PARALLEL)

# Two targets on one command line are made one after the other; otherwise both would compile the same files.
ifneq ($(filter-out programs tests fuzzer figure_programs build/%,$(MAKECMDGOALS)),)
ifneq ($(word 2,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
endif

# ---- The target system, and the libraries of this machine ----

# WINDOWS=1 cross-compiles for Windows; on Windows itself every build is for Windows.
SYSTEM := $(if $(WINDOWS)$(filter Windows_NT,$(OS)),Windows,$(shell uname -s))
MAC := $(filter Darwin,$(SYSTEM))
EXE := $(if $(filter Windows,$(SYSTEM)),.exe)
PKG_CONFIG = pkg-config
# Like MSYS2's compiler, this cross compiler links the C library of Windows 10.
WINDOWS_CC = x86_64-w64-mingw32-gcc -specs=build/windows/ucrt.specs -D_UCRT
ifneq ($(WINDOWS),)
CC = $(WINDOWS_CC)
AR = x86_64-w64-mingw32-ar
PKG_CONFIG = PKG_CONFIG_LIBDIR=build/windows/prefix/lib/pkgconfig pkg-config
else ifneq ($(EXE),)
CC = gcc
endif

comma := ,
found = $(shell $(PKG_CONFIG) --exists $(1) 2>/dev/null && echo yes)
# macOS and Windows have no EGL or OSMesa; a library with such a name is something else there.
BACKENDS := $(if $(call found,glfw3),glfw) $(if $(MAC)$(EXE),,$(if $(call found,egl),egl) \
            $(if $(call found,osmesa),osmesa))
LIBRARIES := libpng $(if $(filter glfw,$(BACKENDS)),glfw3) $(if $(filter egl,$(BACKENDS)),egl)

HAVE := $(if $(filter glfw,$(BACKENDS)),-DHAVE_GLFW) $(if $(filter egl,$(BACKENDS)),-DHAVE_EGL) \
        $(if $(filter osmesa,$(BACKENDS)),-DHAVE_OSMESA)
# -isystem exempts other people's headers from our warnings.
HEADERS := $(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags $(LIBRARIES) cglm 2>/dev/null))
ifneq ($(MAC),)
# On Apple's processors, compilers do not search Homebrew's folder by default.
HEADERS += $(addprefix -isystem ,$(addsuffix /include,$(shell brew --prefix 2>/dev/null)))
endif
ifneq ($(WEB),)
HAVE := -DHAVE_GLFW
HEADERS := -isystem build/web/objects/include
CFLAGS = -Oz -flto -DNDEBUG
endif
# On Windows, link with the same stack size as elsewhere, without the compiler's DLLs, and reproducibly.
LINK := $(shell $(PKG_CONFIG) --libs $(LIBRARIES) 2>/dev/null) $(if $(EXE),-municode -static-libgcc -lgdi32 -lshell32 -lwinmm \
        -Wl$(comma)--stack$(comma)8388608 -Wl$(comma)--no-insert-timestamp $(if $(WINDOWS),-s),-ldl -lm -pthread)
CMOCKA := $(shell $(PKG_CONFIG) --libs cmocka 2>/dev/null)

# Print short lines; V=1 shows the whole commands.
V =
say = $(if $(V),,@echo '$(1)' &&)

# Warnings stop `make lint` and CI, but not a user whose compiler has more warnings than ours.
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion $(if $(CI),-Werror)
# On Windows, the compiler checks format strings against the old C library, which is not the one that is linked, and
# isfinite and similar functions are macros that convert their arguments.
WARNINGS += $(if $(EXE),-Wno-format -Wno-float-conversion)
# A recent clang warns of products of numbers with constants of an enum, such as the size of a texture.
WARNINGS += -Wno-enum-float-conversion
# Fused multiply-add is disabled, so that the programs of the textures compute the same numbers everywhere.
LANGUAGE = -std=c11 -ffp-contract=off -D_XOPEN_SOURCE=700 -Icommon -Ishaders -Itests
LANGUAGE += $(if $(MAC),-D_DARWIN_C_SOURCE) $(if $(EXE),-D_WIN32_WINNT=0x0A00)
COMPILE = $(LANGUAGE) $(WARNINGS) $(HAVE) $(HEADERS) $(INSTRUMENT) $(CFLAGS)

.DEFAULT_GOAL = all

# ---- Targets ----

# `make SANITIZE=1 programs tests` builds with the sanitizers into build/sanitize/. Mesa unloads its drivers, and
# leak reports from unloaded code have no names, so this build has an empty dlclose.
# `make FUZZER=1 fuzzer` builds the target of libFuzzer into build/fuzz/; `make WEB=1 module` builds the programs
# for a browser, as one module, into build/web/.
CHECKS = address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
ifneq ($(FUZZER),)
CC = clang
BUILD = build/fuzz
INSTRUMENT = -fsanitize=fuzzer-no-link,$(CHECKS)
EXTRA =
else ifneq ($(WEB),)
CC = emcc
AR = emar
BUILD = build/web/objects
INSTRUMENT =
EXTRA =
else ifneq ($(WINDOWS),)
BUILD = build/windows
INSTRUMENT = -ffile-prefix-map=$(CURDIR)/=
EXTRA =
else ifeq ($(SANITIZE),)
BUILD = build
INSTRUMENT =
EXTRA =
else
BUILD = build/sanitize
INSTRUMENT = -fsanitize=$(CHECKS)
EXTRA = $(BUILD)/tests/lib/no_dlclose.o
endif

# Sources that need a library this machine lacks are left out.
SOURCES := $(sort $(shell find common -name '*.c'))
ABSENT := $(foreach name,glfw egl osmesa,$(if $(filter $(name),$(BACKENDS)),,common/context/$(name).c))
ABSENT += $(if $(filter glfw,$(BACKENDS)),common/window/none.c,$(filter-out %/none.c %/watch.c,$(filter common/window/%,$(SOURCES))))
# Of the platform's sources, only those for this system are built.
PLATFORM := $(patsubst common/%.c,%,$(filter common/platform/$(if $(EXE),windows,posix)%,$(SOURCES)))
ABSENT += $(filter-out $(PLATFORM:%=common/%.c),$(filter common/platform/%,$(SOURCES)))
# For a browser, common/browser/ replaces some sources.
BROWSER := $(filter common/browser/%,$(SOURCES))
ABSENT += $(if $(WEB),common/window/full_screen.c)
ABSENT += $(if $(WEB),$(patsubst %,common/%.c,context/egl context/osmesa context/guard picture/image_read picture/image_write platform/posix_process platform/posix_display window/none),$(BROWSER))
COMMON := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(ABSENT),$(SOURCES))) $(BUILD)/common/picture/font.o
STEMS := $(patsubst chapters/%.c,%,$(sort $(wildcard chapters/[0-9][0-9]_*.c)))
# The code that tests share is in an archive, from which the linker takes the objects that a test or a figure uses. No
# code refers to choice.c, so that file is linked separately.
SUPPORT := $(filter-out %/system_$(if $(EXE),posix,windows).c %/choice.c %/no_dlclose.c %/user.c %/session.c,$(wildcard tests/lib/*.c))
SUPPORT := $(SUPPORT:%.c=$(BUILD)/%.o)
PARTS := $(BUILD)/tests/parts.a
JUDGE := $(BUILD)/tests/lib/compare.o $(BUILD)/tests/lib/judge.o
PROGRAMS := $(STEMS:%=$(BUILD)/%$(EXE))
LECTURE := $(if $(WEB)$(WINDOWS),,$(BUILD)/lecture$(EXE))
# The steps of the engine in docs/engine.md use nothing from common/. macOS and Windows lack Khronos's glcorearb.h.
FIRST_STEPS := $(if $(MAC)$(EXE),,$(if $(filter-out osmesa,$(BACKENDS)),$(wildcard chapters/first_steps/*.c)))
FIRST_STEPS := $(FIRST_STEPS:chapters/%.c=$(BUILD)/%)
FIGURES := $(patsubst docs/figures/%.c,%,$(filter-out %/svg.c,$(sort $(wildcard docs/figures/*.c))))
# A source that has a header draws no texture: it contains functions for the other sources.
PAINT := $(patsubst %.h,$(BUILD)/%.o,$(wildcard shaders/textures/*.h))
# An archive of these sources, from which the linker takes the objects that a chapter's program uses. For a browser,
# which has no libpng, it does not contain paint.o.
PAINTED := $(BUILD)/shaders/textures/painted.a
TEXTURES := $(patsubst %.c,$(BUILD)/%,$(sort $(wildcard shaders/textures/*.c)))
TEXTURES := $(filter-out $(PAINT:%.o=%),$(TEXTURES))
TESTS := $(sort $(wildcard $(addprefix tests/,$(addsuffix /*.c,unit shaders pictures window command course))))
# Tests that need POSIX processes and limits cannot be built for Windows. Tests with a hidden window need EGL, and all
# tests of the window and its keys need GLFW.
TESTS := $(filter-out $(if $(EXE),$(shell grep -l '<sys/\|<glob' $(TESTS))),$(TESTS))
TESTS := $(filter-out $(if $(filter egl,$(BACKENDS)),,$(shell grep -l 'lib/session' $(TESTS))),$(TESTS))
TESTS := $(filter-out $(if $(filter glfw,$(BACKENDS)),,$(shell grep -l 'lib/session\|lib/user\|window/keys' $(TESTS))),$(TESTS))
# The sanitizers check only C code, so the tests of shaders and pictures, and the programs of figures, would show
# nothing more under them.
TESTS := $(if $(SANITIZE),$(filter-out tests/shaders/% tests/pictures/%,$(TESTS)),$(TESTS))
TESTS := $(TESTS:%.c=$(BUILD)/%$(EXE))

programs: $(PROGRAMS) $(FIRST_STEPS)
tests: $(TESTS) $(LECTURE) $(patsubst %,$(BUILD)/tests/%$(EXE),compare judge draw measure own) $(if $(EXE)$(SANITIZE),,$(FIGURES:%=$(BUILD)/docs/figures/%) $(TEXTURES))
fuzzer: $(BUILD)/tests/fuzz
lecture_program: $(LECTURE)

# In the package for Windows, the code that all programs share is in one library beside them.
SHARED := $(if $(WINDOWS),$(BUILD)/harness.dll)
ENTRY := $(BUILD)/common/platform/windows_main.o
$(PROGRAMS): $(BUILD)/%$(EXE): $(BUILD)/chapters/%.o $(if $(SHARED),$(ENTRY) $(SHARED),$(COMMON)) $(PAINTED) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

$(BUILD)/harness.dll: $(filter-out $(ENTRY),$(COMMON))
	$(call say,link $@) $(CC) -shared $(LDFLAGS) -o $@ $^ $(filter-out -municode,$(LINK))

$(FIRST_STEPS): $(BUILD)/first_steps/%: $(BUILD)/chapters/first_steps/%.o $(EXTRA)
	@mkdir -p $(@D)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

$(PAINTED): $(filter-out $(if $(WEB),%/paint.o),$(PAINT))
	@rm -f $@
	@$(AR) rcs $@ $^

# PAINT is included, so that the code that computes the tables of the sky is itself tested.
$(PARTS): $(SUPPORT) $(PAINT) $(COMMON)
	@rm -f $@
	@$(AR) rcs $@ $^

TEST_PARTS := $(BUILD)/tests/lib/choice.o $(PARTS) $(EXTRA)
$(TESTS): $(BUILD)/tests/%$(EXE): $(BUILD)/tests/%.o $(TEST_PARTS)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(CMOCKA) $(LINK)

# The chapters are compiled to call linked_run instead of chapter_run, so that a test receives their settings.
TOGETHER_PARTS := $(STEMS:%=$(BUILD)/chapters/together/%.o) $(BUILD)/chapters.o
$(BUILD)/tests/draw$(EXE): $(TOGETHER_PARTS)

# A chapter that runs only the course's own shaders.
$(BUILD)/tests/own$(EXE): $(BUILD)/chapters/01_normal_colouring.o $(BUILD)/tests/tools/own.o $(filter-out $(BUILD)/common/dialects/%,$(COMMON)) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

$(patsubst %,$(BUILD)/tests/%$(EXE),measure draw): $(BUILD)/tests/%$(EXE): $(BUILD)/tests/tools/%.o $(TEST_PARTS)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(CMOCKA) $(LINK)

# The tests of the window replace some functions of GLFW. On Windows, where GLFW is linked statically, the linker must
# allow two definitions of these functions.
$(filter-out %/watch$(EXE),$(filter $(BUILD)/tests/window/%,$(TESTS))): $(patsubst %,$(BUILD)/tests/lib/%.o,$(if $(filter egl,$(BACKENDS)),session) user) $(TOGETHER_PARTS)
$(BUILD)/tests/window/%.exe: LDFLAGS += -Wl,--allow-multiple-definition

# compare measures how much two pictures differ; judge uses the same code to check a solution to an exercise.
$(BUILD)/tests/compare$(EXE) $(BUILD)/tests/judge$(EXE): $(BUILD)/tests/%$(EXE): $(BUILD)/tests/tools/%.o $(JUDGE) \
    $(patsubst %,$(BUILD)/common/%.o,picture/image picture/image_read picture/image_write shader/text_file memory report $(PLATFORM)) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

# libFuzzer has its own main.
$(BUILD)/tests/fuzz: $(patsubst %,$(BUILD)/tests/%.o,tools/fuzz lib/fuzz lib/scratch lib/system_posix) $(COMMON)
	$(call say,link $@) $(CC) -fsanitize=fuzzer,$(CHECKS) $(LDFLAGS) -o $@ $^ $(LINK)

# Figures may use the same mathematical functions as the tests.
$(FIGURES:%=$(BUILD)/docs/figures/%): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/docs/figures/svg.o $(PARTS) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(CMOCKA) $(LINK)

$(TEXTURES): $(BUILD)/%: $(BUILD)/%.o $(PAINT) $(patsubst %,$(BUILD)/common/%.o,shader/text_file memory report $(PLATFORM)) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

# The lecture and a browser's module contain all chapters, so each main gets a different name and calls linked_run, which
# leaves the loop to the lecture or to the page.
$(BUILD)/chapters.o: $(BUILD)/chapters.c
	$(call say,$(CC) $<) $(CC) $(COMPILE) -c -o $@ $<

$(BUILD)/chapters.c: Makefile $(STEMS:%=chapters/%.c)
	@mkdir -p $(@D)
	$(call say,echo $@) { echo '#include "linked.h"'; \
	    for stem in $(STEMS); do echo "int main_$$stem(int argc, char **argv);"; done; \
	    echo 'const struct linked_chapter linked_chapters[] = {'; \
	    for stem in $(STEMS); do echo "    {\"$$stem\", main_$$stem},"; done; \
	    echo '    {0, 0}};'; } > $@

TOGETHER = -Dmain=main_$(notdir $*) -Dchapter_run=linked_run
$(LECTURE): $(TOGETHER_PARTS) $(BUILD)/chapters/lecture.o $(COMMON) $(PAINTED) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

$(BUILD)/chapters/together/%.o: chapters/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(call say,$(CC) $<) $(CC) $(COMPILE) $(TOGETHER) -MMD -MP -c -o $@ $<

ifneq ($(WEB),)
$(BUILD)/chapters/%.o: INSTRUMENT = $(TOGETHER)
EXPORTS := _malloc,_free,$(shell grep -oh '\<live_[a-z]*' common/browser/live.h common/browser/canvas.h | sort -u | sed s/^/_/ | paste -sd , -),$(shell grep -oh '\<judge_[a-z]*' tests/lib/judge.h | sort -u | sed s/^/_/ | paste -sd , -)
# From version 3.1.27 on, Emscripten's stack has only 64 KB unless more is asked for.
EMSCRIPTEN = -sTOTAL_STACK=5242880 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH -sMALLOC=emmalloc \
             -sMODULARIZE -sEXPORT_ES6 \
             -sUSE_ES6_IMPORT_META=1 -sENVIRONMENT=web -sEXPORT_NAME=loadHarness -sFORCE_FILESYSTEM \
             -sEXPORTED_RUNTIME_METHODS=FS,ccall,UTF8ToString \
             -sINCOMING_MODULE_JS_API=canvas,print,printErr,locateFile,noInitialRun
# Debian's Emscripten has its JavaScript tools in this folder.
export NODE_PATH = /usr/share/nodejs
module: $(BUILD)/harness.js
$(BUILD)/harness.js: $(STEMS:%=$(BUILD)/chapters/%.o) $(BUILD)/chapters.o $(COMMON) $(JUDGE) $(PAINTED) common/browser/page.js
	$(call say,link $@) $(CC) $(CFLAGS) --no-entry $(EMSCRIPTEN) -sEXPORTED_FUNCTIONS=$(EXPORTS) \
	    --js-library common/browser/page.js -o $@ $(filter %.o %.a,$^)

# These headers are the same on all systems; emcc has its own versions of the others.
$(BUILD)/flags: $(BUILD)/include
$(BUILD)/include:
	@mkdir -p $@
	@for name in cglm stb GLFW; do ln -sfn /usr/include/$$name $@/$$name; done
endif

$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(call say,$(CC) $<) $(CC) $(COMPILE) -MMD -MP -c -o $@ $<

# The overlay's font as a C array.
$(BUILD)/common/picture/font.c: common/picture/font/DejaVuSansCondensed.ttf
	@mkdir -p $(@D)
	$(call say,od $<) (echo '#include "picture/letters.h"'; echo 'const unsigned char letters_font[] = {'; \
	    od -An -v -tu1 $< | sed 's/ *\([0-9][0-9]*\)/\1,/g'; echo '};') > $@

$(BUILD)/common/picture/font.o: $(BUILD)/common/picture/font.c $(BUILD)/flags
	$(call say,$(CC) $<) $(CC) $(COMPILE) -c -o $@ $<

# Everything is compiled again when the compiler, the flags or the libraries of the machine change.
$(BUILD)/flags: always
	@mkdir -p $(@D)
	@echo '$(CC) $(COMPILE) $(TOGETHER) $(LINK)' | cmp -s - $@ || echo '$(CC) $(COMPILE) $(TOGETHER) $(LINK)' > $@

# The tests and CI also use a locale with a decimal comma, if its source is installed.
LOCALE = build/locale/fr_FR.UTF-8
$(LOCALE):
	@mkdir -p $(@D)
	@localedef -i fr_FR -f UTF-8 $@ >/dev/null 2>&1 || true

-include $(shell find $(BUILD)/common $(BUILD)/chapters $(BUILD)/tests $(BUILD)/docs $(BUILD)/shaders -name '*.d' 2>/dev/null)

# ---- To take the course ----

# The first step of most of the commands below.
ready:
	@.make/setup.sh run
	+@$(AGAIN) programs build/tests/compare$(EXE) build/tests/judge$(EXE)

all: ## build every chapter's program in build/ (the default)
	@.make/setup.sh --check run
	+@$(AGAIN) programs

run: ready ## open the course in a window, at chapter 03: make run CHAPTER=03; this chapter alone, with options: OPTIONS='--time 2', or a figure: make run FIGURE=01_march; without a display, render them
	+@$(AGAIN) lecture_program
	@.make/run.sh $(OPTIONS)

play: ready ## open your own shader in a window: make play FILE=my.frag; without FILE, create and open chapters/play.frag
	@.make/play.sh $(OPTIONS)

bake: ready ## show a mesh of your own in chapter 23: make bake MESH=my.obj computes its distance, build/my.png
	+@$(AGAIN) $(BUILD)/shaders/textures/clay$(EXE)
	@.make/bake.sh $(OPTIONS)

lecture: ready ## show the scenes of docs/lecture.txt, or of your own list, full screen: make lecture LIST=my.txt; with NOTES=terminal, your sentences are only printed
	+@$(AGAIN) lecture_program
	@.make/lecture.sh

slides: ready ## typeset the same scenes as slides, build/slides.pdf: make slides LIST=my.txt (installs pandoc and XeLaTeX)
	@.make/setup.sh book
	+@$(AGAIN) lecture_program
	@.make/slides.sh

handouts: ## typeset the labs of docs/teaching.md, build/handouts.pdf, and their answers, build/handouts-answers.pdf
	@.make/setup.sh book
	@.make/handouts.sh

# A wrong answer is a result, not an error, so make succeeds; the status of check.sh is 1.
check: ready ## check a solution: make check EXERCISE=03_2 FILE=my.frag; with FILES='handed_in/*.frag', check many
	@.make/check.sh || [ $$? = 1 ]

marks: ready ## mark a class: make marks FILES='hand-in/*/*.frag' EXERCISES='03_1 03_2' CSV=marks.csv
	@.make/marks.sh

student: ready ## pack the course without solutions and answers, for students: a folder and a zip in build/student/
	@.make/setup.sh student
	@.make/student.sh

questions: ## write the exit questions of docs/questions.txt as GIFT and as Moodle's XML into build/questions/
	@.make/questions.sh

# If the pictures differ, that is a result, not an error, so make succeeds.
compare: ready ## print how much two pictures differ: make compare PICTURES='one.png two.png'
	@.make/compare.sh || [ $$? = 1 ]

diff: ## show what changed since the previous chapter, or step of the engine: make diff CHAPTER=03, CHAPTER=engine_2
	@.make/diff.sh

film: ready ## make an MP4 and a GIF of a chapter with ffmpeg: make film CHAPTER=00 FRAMES=100 FPS=25 VIEW=slice
	@.make/setup.sh film
	@.make/film.sh $(OPTIONS)

gallery: ready ## render every picture of tests/pictures/images.txt into build/gallery/
	@tests/pictures/references.sh gallery

benchmark: ready ## measure every chapter relative to the reference scene; with WRITE=1, write the table to docs/benchmark.md
	+@$(if $(MARCHES),$(AGAIN) build/tests/measure$(EXE))
	@.make/benchmark.sh

book: ## typeset all pages as one PDF, build/book.pdf (installs pandoc and XeLaTeX)
	@.make/setup.sh book
	@.make/book.sh

site: ready web build/node/package-lock.json $(if $(STUDENT),student) ## build a website from all pages, with the programs running in them: build/site/ and build/site.zip; with STUDENT=1, the website for students in build/student/; with ADDRESS=https://…/, links to it are shown with a picture
	@$(if $(STUDENT),.make/student_site.sh,.make/site.sh)

figures-html: ready build/node/package-lock.json ## write each interactive figure as one file for slides and learning platforms, into build/figures/
	@.make/figures_html.sh

serve: site ## serve that website on this machine only, at http://127.0.0.1:8000/; choose another port with PORT=8001
	@node docs/web/serve.mjs build/site $(PORT)

setup: ## install everything that run, test and lint need
	@.make/setup.sh --all run test lint

clean: ## remove build/, except what was added to the course for students
	@.make/clean.sh

help: ## print this list
	@awk -F ':.*## ' '/^# ---- To / { print (n++ ? "\n" : "") substr($$1, 8, length($$1) - 12) } \
	    /^[a-z-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' Makefile

# ---- To work on the course ----

test: ## run the tests, or only some suites: make test SUITE='camera run'
	@tests/run --find $(SUITE)
	@.make/setup.sh test
	+@$(AGAIN) programs tests $(LOCALE)
	$(if $(CI)$(findstring sanitize/,$(SUITE)),+@$(AGAIN) SANITIZE=1 programs tests)
	@tests/run $(SUITE)

test-all: ## run every test before a release; takes an hour or two
	@.make/setup.sh fresh
	ALL=1 $(MAKE) --no-print-directory lint
	ALL=1 $(MAKE) --no-print-directory CI=1 test
	ALL=1 $(MAKE) --no-print-directory CI=1 test-windows
	ALL=1 $(MAKE) --no-print-directory CI=1 test-web
	ALL=1 SID=1 $(MAKE) --no-print-directory CI=1 test-fresh
	$(MAKE) --no-print-directory mutants

test-fresh: ## try `make run` and `make test` on fresh, bare Debian systems, as root and as a user; needs root
	@.make/setup.sh fresh
	@.make/fresh.sh

test-gpu: ready ## compare the references with pictures of this machine's GPU; reports differences but never fails
	@tests/pictures/references.sh gpu

test-windows: ready windows ## test the programs for Windows with Wine: units, pictures, failures, windows; takes several minutes
	@.make/setup.sh wine
	+@$(AGAIN) WINDOWS=1 $(if $(ALL)$(SUITE),tests,build/windows/tests/draw.exe)
	@tests/windows/run.sh $(SUITE)

fuzz: ## fuzz the parsers of shaders, parameters and command lines, each for DURATION=60 seconds
	@.make/setup.sh run fuzz
	+@$(AGAIN) FUZZER=1 fuzzer
	@.make/fuzz.sh

monkey: ## play with the windows at random: make monkey SECONDS=60 PROGRAM=23; the same SEED plays the same
	@.make/setup.sh test
	+@$(AGAIN) SANITIZE=1 build/sanitize/tests/window/monkey
	@. tests/lib/tap.sh; build/sanitize/tests/window/monkey "$${SEED:-$$(date +%s)}" "$${SECONDS:-60}" "$$PROGRAM"

mutants: ## check that the tests notice mistakes: make mutants FILES='shaders/march.glsl common/camera.c' COUNT=30 SEED=1
	@.make/setup.sh test
	+@$(AGAIN) programs tests
	@.make/mutants.sh

lint: ## run all checkers on C, GLSL and scripts; warnings are errors
	@.make/setup.sh lint
	+@$(AGAIN) programs
	@CFLAGS='$(LANGUAGE) $(WARNINGS) -Werror $(HAVE) $(HEADERS)' .make/lint.sh

format: ## format the C sources according to .clang-format
	@.make/setup.sh lint
	@clang-format -i $$(find common chapters shaders tests docs -name '*.[ch]')

chapter: ## create a chapter with the next number: make chapter NAME=soft_shadows
	@.make/chapter.sh

docs: ready ## regenerate the listings and tables in docs/ from the sources
	@.make/listings.sh

web: ## build the programs for a browser in build/web/ (installs Emscripten)
	@.make/setup.sh web
	+@$(AGAIN) build/node/package-lock.json
	+@$(AGAIN) WEB=1 module
	@.make/web.sh

test-web: ready site build/tests/compare ## test and measure the programs in Chromium and Firefox, without a display, on Mesa's software renderer
	@.make/setup.sh browsers
	@JOBS=2 tests/run web

# The npm packages of docs/web/, in the versions of its lock file.
build/node/package-lock.json: docs/web/package.json docs/web/package-lock.json
	@mkdir -p $(@D) && cp $^ $(@D)/
	$(call say,npm ci) npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --loglevel=error >/dev/null
	@touch $@

windows: ## cross-compile the programs for Windows in build/windows/, on Debian (installs a cross compiler)
	@.make/setup.sh windows
	@CC='$(WINDOWS_CC)' .make/windows_libraries.sh
	+@$(AGAIN) WINDOWS=1 programs build/windows/tests/compare.exe build/windows/tests/judge.exe

windows-zip: windows ## pack the programs for Windows and all the files that they read into build/ray-marching-windows.zip
	@.make/windows_zip.sh

figures: ## redraw the diagrams of docs/figures/
	@.make/setup.sh test
	+@$(AGAIN) figure_programs
	@.make/figures.sh $(FIGURES)

figure_programs: $(FIGURES:%=$(BUILD)/docs/figures/%)

textures: ## redraw the textures of shaders/textures/
	@.make/setup.sh test
	+@$(AGAIN) texture_programs
	@.make/textures.sh

texture_programs: $(TEXTURES) $(BUILD)/tests/compare$(EXE)

references: ready ## regenerate the references, or those of CHAPTER=03, that are out of tolerance; with FORCE=1, all that differ
	@tests/pictures/references.sh update

always:
.PHONY: all programs tests fuzzer lecture_program ready run play bake lecture slides handouts check marks student questions compare diff film gallery benchmark book setup clean help test \
        test-all test-fresh test-gpu fuzz monkey mutants lint format chapter docs figures figure_programs figures-html textures texture_programs \
        references web test-web test-windows site serve module windows windows-zip always
.DELETE_ON_ERROR:
.SUFFIXES:
.SECONDARY:
