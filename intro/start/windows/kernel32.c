/* Replaces kernel32.dll when the film is linked: the film's two imports. */
void *LoadLibraryA(const char *name) { return (void *)name; }
void *GetProcAddress(void *library, const char *name) { return name ? 0 : library; }
