// Of each function the one that the GNU C library takes on this processor.

static int multipliesAndAdds(void)
{
    return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
}

#define CHOSEN(name)                                                                               \
    double usual_##name(double x);                                                                 \
    double fma_##name(double x);                                                                   \
    double name(double x) { return multipliesAndAdds() ? fma_##name(x) : usual_##name(x); }

#define CHOSEN_OF_TWO(name)                                                                        \
    double usual_##name(double x, double y);                                                       \
    double fma_##name(double x, double y);                                                         \
    double name(double x, double y)                                                                \
    {                                                                                              \
        return multipliesAndAdds() ? fma_##name(x, y) : usual_##name(x, y);                        \
    }

CHOSEN(sin)
CHOSEN(cos)
CHOSEN(tan)
CHOSEN(asin)
CHOSEN(acos)
CHOSEN(atan)
CHOSEN(exp)
CHOSEN(log)
CHOSEN(log2)
CHOSEN_OF_TWO(atan2)
CHOSEN_OF_TWO(pow)
