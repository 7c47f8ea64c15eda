/* Replaces libdl.so.2 when the film is linked, so that its imports have no symbol versions. The film then
   runs with every glibc, whether dlopen is in libdl.so.2 or in libc.so.6. */
void *dlopen(const char *name, int mode) { return name ? 0 : (void *)(long)mode; }
void *dlsym(void *library, const char *name) { return name ? 0 : library; }
