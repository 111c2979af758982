// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs.h"

int main(int argc, char** argv) { return alidade::run_words(alidade::Words(argv + 1, argv + argc)); }
