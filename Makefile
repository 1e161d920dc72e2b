# Every command that a person types: `make help` lists them. GNU make 3.81 suffices.
# Chapters, modules and tests are found by name, never listed.

# The pictures are the driver's work: -O2 compiles a quarter longer and draws no faster. What WINDOWS=1 makes is handed
# out, without names for a debugger.
CFLAGS ?= -O1$(if $(WINDOWS),, -g)
OPTIONS =
CHAPTER =
SUITE =
EXERCISE =
NAME =
FILE =
FILES =
PICTURES =
FORCE =
FRAMES =
FPS =
VIEW =
ROUNDS =
WRITE =
WEB =
WINDOWS =
PORT = 8000
DURATION =
SANITIZE =
FUZZER =
# What awk, sort and gcc read and print does not depend on the reader's language.
export LC_ALL = C
export CHAPTER SUITE NAME EXERCISE FILE FILES PICTURES FORCE FRAMES FPS VIEW ROUNDS WRITE DURATION

# Recursive makes run in parallel, unless the caller has said how.
CPUS := $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
JOBS = $(if $(filter -j% --jobserver%,$(MAKEFLAGS)),,-j$(CPUS))
# Where a recipe says it, '+' hands the caller's jobs on: make looks for the word MAKE itself.
AGAIN = $(MAKE) --no-print-directory $(if $(V),,-s) $(JOBS)

# Two commands at once are carried out one after the other, or both would compile the same files.
ifneq ($(filter-out programs tests fuzzer figure_programs build/%,$(MAKECMDGOALS)),)
ifneq ($(word 2,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
endif

# ---- What the programs are for, and what this machine has ----

# WINDOWS=1 asks a cross compiler for programs for Windows; on Windows itself they are for it anyway.
SYSTEM := $(if $(WINDOWS)$(filter Windows_NT,$(OS)),Windows,$(shell uname -s))
MAC := $(filter Darwin,$(SYSTEM))
EXE := $(if $(filter Windows,$(SYSTEM)),.exe)
PKG_CONFIG = pkg-config
# As MSYS2's: it links the C library of Windows 10.
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
# A Mac and Windows have neither EGL nor OSMesa of their own: what calls itself so there is something else.
BACKENDS := $(if $(call found,glfw3),glfw) $(if $(MAC)$(EXE),,$(if $(call found,egl),egl) \
            $(if $(call found,osmesa),osmesa))
LIBRARIES := libpng $(if $(filter glfw,$(BACKENDS)),glfw3) $(if $(filter egl,$(BACKENDS)),egl)

HAVE := $(if $(filter glfw,$(BACKENDS)),-DHAVE_GLFW) $(if $(filter egl,$(BACKENDS)),-DHAVE_EGL) \
        $(if $(filter osmesa,$(BACKENDS)),-DHAVE_OSMESA)
# Other people's headers are not held to our warnings: -isystem.
HEADERS := $(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags $(LIBRARIES) cglm 2>/dev/null))
ifneq ($(MAC),)
# No compiler searches Homebrew's folder by itself where the processor is Apple's.
HEADERS += $(addprefix -isystem ,$(addsuffix /include,$(shell brew --prefix 2>/dev/null)))
endif
ifneq ($(WEB),)
HAVE := -DHAVE_GLFW
HEADERS := -isystem build/web/objects/include
CFLAGS = -Oz -flto -DNDEBUG
endif
# Windows: a stack as elsewhere, no file of the compiler's beside the program, and the same bytes at any time.
LINK := $(shell $(PKG_CONFIG) --libs $(LIBRARIES) 2>/dev/null) $(if $(EXE),-municode -static-libgcc -lgdi32 -lshell32 -lwinmm \
        -Wl$(comma)--stack$(comma)8388608 -Wl$(comma)--no-insert-timestamp $(if $(WINDOWS),-s),-ldl -lm -pthread)
CMOCKA := $(shell $(PKG_CONFIG) --libs cmocka 2>/dev/null)

# Short lines; V=1 shows the whole commands.
V =
say = $(if $(V),,@echo '$(1)' &&)

# A warning stops `make lint` and CI, not a reader whose compiler knows more of them.
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion $(if $(CI),-Werror)
# What a format may hold is judged on Windows by its old C library, which is not the one that is linked.
# Its isfinite and the like are macros that convert.
WARNINGS += $(if $(EXE),-Wno-format -Wno-float-conversion)
# No product and sum are rounded in one: what a texture's program computes is the same everywhere.
LANGUAGE = -std=c11 -ffp-contract=off -D_XOPEN_SOURCE=700 -Icommon
LANGUAGE += $(if $(MAC),-D_DARWIN_C_SOURCE) $(if $(EXE),-D_WIN32_WINNT=0x0A00)
COMPILE = $(LANGUAGE) $(WARNINGS) $(HAVE) $(HEADERS) $(INSTRUMENT) $(CFLAGS)

.DEFAULT_GOAL = all

# ---- What is built ----

# The sanitizers: `make SANITIZE=1 programs tests` builds the same into build/sanitize/. Mesa unloads
# its drivers, and a leak report from unloaded code has no names: so dlclose is empty there.
# `make FUZZER=1 fuzzer` builds what libFuzzer watches into build/fuzz/, `make WEB=1 module` the same
# sources for a browser into build/web/.
CHECKS = address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
ifneq ($(FUZZER),)
CC = clang
BUILD = build/fuzz
INSTRUMENT = -fsanitize=fuzzer-no-link,$(CHECKS)
EXTRA =
else ifneq ($(WEB),)
CC = emcc
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
EXTRA = $(BUILD)/tests/no_dlclose.o
endif

# What this machine has no library for is left out.
SOURCES := $(sort $(shell find common -name '*.c'))
ABSENT := $(foreach name,glfw egl osmesa,$(if $(filter $(name),$(BACKENDS)),,common/context/$(name).c))
ABSENT += $(if $(filter glfw,$(BACKENDS)),common/window/none.c,$(filter-out %/none.c %/watch.c,$(filter common/window/%,$(SOURCES))))
# What each system does in its own way.
PLATFORM := $(patsubst common/%.c,%,$(filter common/platform/$(if $(EXE),windows,posix)%,$(SOURCES)))
ABSENT += $(filter-out $(PLATFORM:%=common/%.c),$(filter common/platform/%,$(SOURCES)))
# In a browser common/browser/ takes the place of some of them.
BROWSER := $(filter common/browser/%,$(SOURCES))
ABSENT += $(if $(WEB),$(patsubst %,common/%.c,context/egl context/osmesa context/guard picture/image_read picture/image_write platform/posix_process window/none),$(BROWSER))
COMMON := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(ABSENT),$(SOURCES))) $(BUILD)/common/picture/font.o
STEMS := $(patsubst chapters/%.c,%,$(sort $(wildcard chapters/[0-9][0-9]_*.c)))
SUPPORT := $(filter-out tests/support_system_$(if $(EXE),posix,windows).c,$(wildcard tests/support_*.c))
SUPPORT := $(SUPPORT:%.c=$(BUILD)/%.o)
# All that a test or a figure may ask; of an archive the linker takes what is asked. support_choice.c is asked by nobody.
PARTS := $(BUILD)/tests/parts.a
JUDGE := $(BUILD)/tests/support_compare.o $(BUILD)/tests/support_judge.o
PROGRAMS := $(STEMS:%=$(BUILD)/%$(EXE))
# Two whole programs that need one library each and nothing of common/; Khronos' header is no part of a Mac,
# and not of Windows.
FIRST_STEPS := $(if $(MAC)$(EXE),,$(if $(filter glfw,$(BACKENDS)),window)) $(if $(filter egl,$(BACKENDS)),picture)
FIRST_STEPS := $(FIRST_STEPS:%=$(BUILD)/first_steps/%)
FIGURES := $(patsubst docs/figures/%.c,%,$(filter-out %/svg.c,$(sort $(wildcard docs/figures/*.c))))
# A source with a header of its own draws nothing: it helps the others.
PAINT := $(patsubst %.h,$(BUILD)/%.o,$(wildcard shaders/textures/*.h))
TEXTURES := $(patsubst %.c,$(BUILD)/%,$(sort $(wildcard shaders/textures/*.c)))
TEXTURES := $(filter-out $(PAINT:%.o=%),$(TEXTURES))
TESTS := $(sort $(wildcard tests/test_*.c))
# What asks for processes and limits of POSIX cannot be built for Windows.
TESTS := $(filter-out $(if $(EXE),$(shell grep -l '<sys/\|<glob' $(TESTS))),$(TESTS))
TESTS := $(TESTS:%.c=$(BUILD)/%$(EXE))

programs: $(PROGRAMS) $(FIRST_STEPS)
tests: $(TESTS) $(patsubst %,$(BUILD)/tests/%$(EXE),compare judge draw measure) $(if $(EXE),,$(FIGURES:%=$(BUILD)/docs/figures/%) $(TEXTURES))
fuzzer: $(BUILD)/tests/fuzz

# What is packed for others has what all programs do once, in a library beside them.
SHARED := $(if $(WINDOWS),$(BUILD)/harness.dll)
ENTRY := $(BUILD)/common/platform/windows_main.o
$(PROGRAMS): $(BUILD)/%$(EXE): $(BUILD)/chapters/%.o $(if $(SHARED),$(ENTRY) $(SHARED),$(COMMON)) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

$(BUILD)/harness.dll: $(filter-out $(ENTRY),$(COMMON))
	$(call say,link $@) $(CC) -shared $(LDFLAGS) -o $@ $^ $(filter-out -municode,$(LINK))

$(FIRST_STEPS): $(BUILD)/first_steps/%: $(BUILD)/chapters/first_steps/%.o $(EXTRA)
	@mkdir -p $(@D)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

# What the tables of the sky are computed by is tested as it is.
$(PARTS): $(SUPPORT) $(PAINT) $(COMMON)
	@rm -f $@
	@$(AR) rcs $@ $^

$(TESTS) $(patsubst %,$(BUILD)/tests/%$(EXE),measure draw): $(BUILD)/tests/%$(EXE): $(BUILD)/tests/%.o $(BUILD)/tests/support_choice.o $(PARTS) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(CMOCKA) $(LINK)

# It has functions of its own in the place of GLFW's, which is no library by itself on Windows.
$(BUILD)/tests/test_input.exe: LDFLAGS += -Wl,--allow-multiple-definition

# What says how far two pictures are apart, and what judges an answer to an exercise by that.
$(BUILD)/tests/compare$(EXE) $(BUILD)/tests/judge$(EXE): $(BUILD)/tests/%$(EXE): $(BUILD)/tests/%.o $(JUDGE) \
    $(patsubst %,$(BUILD)/common/%.o,picture/image picture/image_read picture/image_write shader/text_file memory report $(PLATFORM)) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

# libFuzzer brings its own main.
$(BUILD)/tests/fuzz: $(patsubst %,$(BUILD)/tests/%.o,fuzz support_fuzz support_scratch support_system_posix) $(COMMON)
	$(call say,link $@) $(CC) -fsanitize=fuzzer,$(CHECKS) $(LDFLAGS) -o $@ $^ $(LINK)

# A figure may ask the mathematics that the tests ask.
$(FIGURES:%=$(BUILD)/docs/figures/%): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/docs/figures/svg.o $(PARTS) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(CMOCKA) $(LINK)

$(TEXTURES): $(BUILD)/%: $(BUILD)/%.o $(PAINT) $(EXTRA)
	$(call say,link $@) $(CC) $(INSTRUMENT) $(LDFLAGS) -o $@ $^ $(LINK)

# One module holds all chapters, so each main gets a name of its own; what it calls leaves the loop to the page.
ifneq ($(WEB),)
$(BUILD)/chapters/%.o: INSTRUMENT = -Dmain=main_$(notdir $*) -Dchapter_run=live_run
EXPORTS := _malloc,_free,$(shell grep -oh '\<live_[a-z]*' common/browser/live.h common/browser/hands.h | sort -u | sed s/^/_/ | paste -sd , -),$(shell grep -oh '\<judge_[a-z]*' tests/support_judge.h | sort -u | sed s/^/_/ | paste -sd , -)
EMSCRIPTEN = -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH -sMALLOC=emmalloc -sMODULARIZE -sEXPORT_ES6 \
             -sUSE_ES6_IMPORT_META=1 -sENVIRONMENT=web -sEXPORT_NAME=loadHarness -sFORCE_FILESYSTEM \
             -sEXPORTED_RUNTIME_METHODS=FS,ccall,UTF8ToString \
             -sINCOMING_MODULE_JS_API=canvas,print,printErr,locateFile,noInitialRun
# Debian's has its JavaScript tools there.
export NODE_PATH = /usr/share/nodejs
module: build/web/harness.js
build/web/harness.js: $(STEMS:%=$(BUILD)/chapters/%.o) $(BUILD)/chapters.o $(COMMON) $(JUDGE) common/browser/page.js
	$(call say,link $@) $(CC) $(CFLAGS) --no-entry $(EMSCRIPTEN) -sEXPORTED_FUNCTIONS=$(EXPORTS) \
	    --js-library common/browser/page.js -o $@ $(filter %.o,$^)

$(BUILD)/chapters.o: $(BUILD)/chapters.c
	$(call say,$(CC) $<) $(CC) $(COMPILE) -c -o $@ $<

$(BUILD)/chapters.c: Makefile $(STEMS:%=chapters/%.c)
	@mkdir -p $(@D)
	$(call say,echo $@) { echo '#include "browser/chapters.h"'; \
	    for stem in $(STEMS); do echo "int main_$$stem(int argc, char **argv);"; done; \
	    echo 'const struct live_chapter live_chapters[] = {'; \
	    for stem in $(STEMS); do echo "    {\"$$stem\", main_$$stem},"; done; \
	    echo '    {0, 0}};'; } > $@

# The headers that are the same everywhere; emcc has its own of the rest.
$(BUILD)/flags: $(BUILD)/include
$(BUILD)/include:
	@mkdir -p $@
	@for name in cglm stb GLFW; do ln -sfn /usr/include/$$name $@/$$name; done
endif

$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(call say,$(CC) $<) $(CC) $(COMPILE) -MMD -MP -c -o $@ $<

# The overlay's font, as numbers of a C array.
$(BUILD)/common/picture/font.c: common/picture/font/DejaVuSansCondensed.ttf
	@mkdir -p $(@D)
	$(call say,od $<) (echo '#include "picture/letters.h"'; echo 'const unsigned char letters_font[] = {'; \
	    od -An -v -tu1 $< | sed 's/ *\([0-9][0-9]*\)/\1,/g'; echo '};') > $@

$(BUILD)/common/picture/font.o: $(BUILD)/common/picture/font.c $(BUILD)/flags
	$(call say,$(CC) $<) $(CC) $(COMPILE) -c -o $@ $<

# Everything is compiled again when the compiler, the flags or what the machine has change.
$(BUILD)/flags: always
	@mkdir -p $(@D)
	@echo '$(CC) $(COMPILE) $(LINK)' | cmp -s - $@ || echo '$(CC) $(COMPILE) $(LINK)' > $@

# The tests and CI try a language that writes a comma in its numbers, where its source is at hand.
LOCALE = build/locale/fr_FR.UTF-8
$(LOCALE):
	@mkdir -p $(@D)
	@localedef -i fr_FR -f UTF-8 $@ >/dev/null 2>&1 || true

-include $(shell find $(BUILD)/common $(BUILD)/chapters $(BUILD)/tests $(BUILD)/docs $(BUILD)/shaders -name '*.d' 2>/dev/null)

# ---- To learn by ----

# What most of the commands below begin with.
ready:
	@.make/setup.sh run
	+@$(AGAIN) programs build/tests/compare$(EXE) build/tests/judge$(EXE)

all: ## build every chapter's program into build/ (the default)
	@.make/setup.sh --check run
	+@$(AGAIN) programs

run: ready ## open a chapter in a window: make run CHAPTER=03 OPTIONS='--time 2'; without a display, render all
	@.make/run.sh $(OPTIONS)

play: ready ## open your own shader in a window: make play FILE=my.frag; without FILE chapters/play.frag, made for you
	@.make/play.sh $(OPTIONS)

check: ready ## is a solution right? make check EXERCISE=03_2 FILE=my.frag; FILES='handed_in/*.frag' for a table
	@.make/check.sh

# Pictures that differ are an answer, no error of make's.
compare: ready ## by how much do two pictures differ? make compare PICTURES='one.png two.png'
	@.make/compare.sh || [ $$? = 1 ]

diff: ## show what changed since the chapter before: make diff CHAPTER=03
	@.make/diff.sh

film: ready ## make an MP4 and a GIF of a chapter by ffmpeg: make film CHAPTER=00 FRAMES=100 FPS=25 VIEW=slice
	@.make/film.sh $(OPTIONS)

gallery: ready ## render every picture of tests/images.txt into build/gallery/
	@tests/references.sh gallery

benchmark: ready ## measure every chapter against the reference scene; WRITE=1 keeps the table in docs/benchmark.md
	@.make/benchmark.sh

book: ## set all pages as one PDF, build/book.pdf (pandoc and XeLaTeX, a package set of its own)
	@.make/setup.sh book
	@.make/book.sh

site: web build/node/package-lock.json ## set all pages as a web site with their programs alive: build/site/ and build/site.zip
	@.make/site.sh

serve: site ## show that site on this machine alone: http://127.0.0.1:8000/, or another PORT
	@node docs/web/serve.mjs build/site $(PORT)

setup: ## install what run, test and lint need
	@.make/setup.sh --all run test lint

clean: ## remove build/
	rm -rf build

help: ## this list
	@awk -F ':.*## ' '/^# ---- To / { print (n++ ? "\n" : "") substr($$1, 8, length($$1) - 12) } \
	    /^[a-z-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' Makefile

# ---- To work on the course ----

test: ## run every test; make test SUITE='camera run' runs these
	@tests/run.sh --find $(SUITE)
	@.make/setup.sh test
	+@$(AGAIN) programs tests $(LOCALE)
	$(if $(CI)$(findstring sanitize/,$(SUITE)),+@$(AGAIN) SANITIZE=1 programs tests)
	@tests/run.sh $(SUITE)

test-fresh: ## type `make run` and `make test` on bare Debian machines made for it, as root and as a user; needs root
	@.make/setup.sh fresh
	@.make/fresh.sh

test-gpu: ready ## compare the references with this machine's own GPU; reports, does not judge
	@tests/references.sh gpu

test-windows: ready windows ## try the programs for Windows under Wine: units, pictures, failures, windows; some minutes
	@.make/setup.sh wine
	+@$(AGAIN) WINDOWS=1 tests
	@tests/windows.sh $(SUITE)

fuzz: ## feed made-up bytes to the readers of shaders, parameters and command lines; DURATION=60 seconds each
	@.make/setup.sh run fuzz
	+@$(AGAIN) FUZZER=1 fuzzer
	@.make/fuzz.sh

lint: ## hold C, GLSL and scripts against every checker; warnings are errors
	@.make/setup.sh lint
	+@$(AGAIN) programs
	@CFLAGS='$(LANGUAGE) $(WARNINGS) -Werror $(HAVE) $(HEADERS)' .make/lint.sh

format: ## lay out the C sources by .clang-format
	@.make/setup.sh lint
	@clang-format -i $$(find common chapters shaders tests docs -name '*.[ch]')

chapter: ## begin a chapter with the next number: make chapter NAME=soft_shadows
	@.make/chapter.sh

docs: ready ## rewrite the listings and tables in docs/ from the sources that they show
	@.make/listings.sh

web: ## build the programs for a browser into build/web/ (Emscripten; a package set of its own)
	@.make/setup.sh web
	+@$(AGAIN) build/node/package-lock.json
	+@$(AGAIN) WEB=1 module
	@.make/web.sh

test-web: ready site build/tests/compare ## draw, drive and measure the programs in Chromium and Firefox, without a screen, on Mesa's software renderer
	@tests/web.sh

# What docs/web/ takes from npm, as its lock file has it.
build/node/package-lock.json: docs/web/package.json docs/web/package-lock.json
	@mkdir -p $(@D) && cp $^ $(@D)/
	$(call say,npm ci) npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --silent
	@touch $@

windows: ## cross-compile the programs for Windows into build/windows/, on Debian (a package set of its own)
	@.make/setup.sh windows
	@CC='$(WINDOWS_CC)' .make/windows_libraries.sh
	+@$(AGAIN) WINDOWS=1 programs build/windows/tests/compare.exe build/windows/tests/judge.exe

windows-zip: windows ## pack them with all that they read, for another's Windows: build/ray-marching-windows.zip
	@.make/windows_zip.sh

figures: ## draw the diagrams of docs/figures/ again
	@.make/setup.sh test
	+@$(AGAIN) figure_programs
	@for name in $(FIGURES); do build/docs/figures/$$name > docs/figures/$$name.svg || exit 1; done

figure_programs: $(FIGURES:%=$(BUILD)/docs/figures/%)

textures: ## draw the textures of shaders/textures/ again
	@.make/setup.sh test
	+@$(AGAIN) texture_programs
	@.make/textures.sh

texture_programs: $(TEXTURES) $(BUILD)/tests/compare$(EXE)

references: ready ## render the reference pictures again; those within tolerance stay (FORCE=1 rewrites all)
	@tests/references.sh update

always:
.PHONY: all programs tests fuzzer ready run play check compare diff film gallery benchmark book setup clean help test \
        test-fresh test-gpu fuzz lint format chapter docs figures figure_programs textures texture_programs \
        references web test-web test-windows site serve module windows windows-zip always
.DELETE_ON_ERROR:
.SUFFIXES:
.SECONDARY:
