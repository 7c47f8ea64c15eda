int twice(int i) {
    int all = 0;
    for (int n = 0; n < i; ++n) all += n % 3 ? 2 : i;
    return all;
}
