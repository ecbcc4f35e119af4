// SPDX-License-Identifier: MIT
// To be preloaded: a libavcodec that was built without encoders.

extern "C" const void* avcodec_find_encoder_by_name(const char* name);

extern "C" const void* avcodec_find_encoder_by_name(const char*) { return nullptr; }
