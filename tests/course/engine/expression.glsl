float doubled(float x)
{
    return x + radios;
}
