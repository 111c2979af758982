/* SPDX-License-Identifier: Apache-2.0
 *
 * What passes between the program and the image module, a shared library that is opened when a picture needs it. Plain C types and no
 * exceptions, so that neither side depends on how the other was compiled. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#define ALIDADE_IMAGE_ABI 4
#define ALIDADE_IMAGE_ENTRY "alidade_image_module"

extern "C" {

/* Rows from the top, channels interleaved. `bits` of the file's samples: 8, 16, or 0 for floats. Decode: `more_pages` is 1 if the file has further pictures,
 * `orientation` is Exif's, 1 for none; the pixels are as they are stored. */
struct AlidadeImageInfo {
    uint32_t width, height, channels, bits;
    const char* const* names;
    uint32_t more_pages, orientation;
};

/* The program's side of one call. A callback that returns null or 0 has refused, and has written why into `error`. */
struct AlidadeImageCall {
    void* context;
    float* (*allocate)(struct AlidadeImageCall* call, const struct AlidadeImageInfo* info);   /* decode: where the pixels go, 0..1 for integers */
    int (*write)(struct AlidadeImageCall* call, const void* bytes, size_t size);              /* encode: once, the whole file */
    char error[512];
};

/* `format` is OpenImageIO's name for it. The functions return 1, or 0 with call->error filled. encode's `pixels` are bytes if info->bits is 8,
 * floats if it is 0. */
struct AlidadeImageModule {
    uint32_t abi;
    int (*decode)(const char* format, const void* bytes, size_t size, struct AlidadeImageCall* call);
    int (*encode)(const char* format, const struct AlidadeImageInfo* info, const void* pixels, struct AlidadeImageCall* call);
};

/* The one symbol of the module. */
const struct AlidadeImageModule* alidade_image_module(void);
}
